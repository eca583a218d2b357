(* What the verified function is shown: barycentric coordinates, circumcentres, neighbours, boxes, cells of a grid.
   Nothing rests on this file: a wrong hint is refused. *)

open Lattice_file

let dot a b =
  let sum = ref Z.zero in
  Array.iteri (fun k x -> sum := Z.add !sum (Z.mul x b.(k))) a;
  !sum

(* The determinant and its product with the inverse matrix, by elimination without fractions (Bareiss). None if it is 0. *)
let inverse matrix =
  let n = Array.length matrix in
  let rows = Array.init n (fun i -> Array.init (2 * n) (fun j -> if j < n then matrix.(i).(j) else if j = n + i then Z.one else Z.zero)) in
  let previous = ref Z.one in
  try
    for k = 0 to n - 1 do
      let pivot = ref k in
      while !pivot < n && Z.equal rows.(!pivot).(k) Z.zero do incr pivot done;
      if !pivot = n then raise Exit;
      if !pivot <> k then begin
        let row = rows.(k) in
        rows.(k) <- rows.(!pivot);
        rows.(!pivot) <- Array.map Z.neg row
      end;
      let row = rows.(k) in
      for i = 0 to n - 1 do
        if i <> k then begin
          let factor = rows.(i).(k) in
          rows.(i) <- Array.mapi (fun j x -> Z.divexact (Z.sub (Z.mul row.(k) x) (Z.mul factor row.(j))) !previous) rows.(i)
        end
      done;
      previous := row.(k)
    done;
    Some (!previous, Array.map (fun row -> Array.sub row n n) rows)
  with Exit -> None

let transposed matrix = Array.init (Array.length matrix.(0)) (fun j -> Array.map (fun row -> row.(j)) matrix)

(* factor·G = stretch·1 + Σ c l lᵀ with c ≥ 0, stretch > 0: the Cholesky factors of G less a small multiple of 1. *)
let squares_of gram =
  let m = Array.length gram in
  let rec attempt tries stretch =
    if tries = 0 then None
    else begin
      let rest = Array.mapi (fun i row -> Array.mapi (fun j x -> let q = Q.of_bigint x in if i = j then Q.sub q stretch else q) row) gram in
      let rec columns k found =
        if k = m then Some (List.rev found)
        else begin
          let pivot = rest.(k).(k) in
          if Q.sign pivot <= 0 then None
          else begin
            let column = Array.init m (fun i -> if i < k then Q.zero else Q.div rest.(i).(k) pivot) in
            for i = 0 to m - 1 do
              for j = 0 to m - 1 do
                rest.(i).(j) <- Q.sub rest.(i).(j) (Q.mul pivot (Q.mul column.(i) column.(j)))
              done
            done;
            columns (k + 1) ((pivot, column) :: found)
          end
        end
      in
      match columns 0 [] with
      | Some found -> Some (stretch, found)
      | None -> attempt (tries - 1) (Q.div stretch (Q.of_int 2))
    end
  in
  match attempt 400 Q.one with
  | None -> (Z.zero, Z.zero, [])
  | Some (stretch, found) ->
      let cleared (pivot, column) =
        let common = Array.fold_left (fun d x -> Z.lcm d (Q.den x)) Z.one column in
        let whole = Array.map (fun x -> Q.num (Q.mul x (Q.of_bigint common))) column in
        (Q.div pivot (Q.of_bigint (Z.mul common common)), whole)
      in
      let found = List.map cleared found in
      let factor = List.fold_left (fun d (c, _) -> Z.lcm d (Q.den c)) (Q.den stretch) found in
      let times q = Q.num (Q.mul q (Q.of_bigint factor)) in
      (factor, times stretch, List.map (fun (c, l) -> (times c, Array.to_list l)) found)

let position content (label, shift) =
  if label < Array.length content.points then
    Array.mapi (fun k x -> Z.add x (Z.mul content.period shift.(k))) content.points.(label)
  else Array.make content.dimension Z.zero

(* The facet of s without its vertex at place i, up to translations, and the lattice vector of its first vertex. *)
let facet s i =
  let others = List.filteri (fun k _ -> k <> i) (Array.to_list s) in
  let sorted = List.sort (fun (a, x) (b, y) -> if a <> b then compare a b else
      let rec order k = if k = Array.length x then 0 else match Z.compare x.(k) y.(k) with 0 -> order (k + 1) | c -> c in order 0) others in
  let first = snd (List.hd sorted) in
  let text = Buffer.create 64 in
  List.iter (fun (label, shift) ->
      Buffer.add_string text (string_of_int label);
      Array.iteri (fun k x -> Buffer.add_char text ' '; Buffer.add_string text (Z.to_string (Z.sub x first.(k)))) shift;
      Buffer.add_char text ';') sorted;
  (Buffer.contents text, first)

let facet_table content =
  let table = Hashtbl.create (1 + (4 * Array.length content.simplices)) in
  Array.iteri (fun k s -> Array.iteri (fun i _ -> let text, first = facet s i in Hashtbl.add table text (k, i, first)) s) content.simplices;
  table

let no_hints : Verified_core.simplex_hints =
  { volume = Z.zero; forms = []; centre_denominator = Z.zero; centre = []; neighbours = []; lowest = []; highest = [] }

let hints_of_simplex content gram_inverse table k s : Verified_core.simplex_hints =
  let vertices = Array.map (position content) s in
  let homogeneous = Array.map (Array.append [| Z.one |]) vertices in
  match (inverse (transposed homogeneous), gram_inverse) with
  | None, _ | _, None -> no_hints
  | Some (volume, forms), Some (gram_volume, gram_adjugate) ->
      let sign = Z.of_int (Z.sign volume) in
      let volume = Z.mul sign volume and forms = Array.map (Array.map (Z.mul sign)) forms in
      (* |x|² less the power is the affine function with the values |v|² at the vertices. *)
      let square v = dot v (Array.map (fun row -> dot row v) content.gram) in
      let squares = Array.map square vertices in
      let linear = Array.init content.dimension (fun c -> dot (Array.map (fun form -> form.(c + 1)) forms) squares) in
      let denominator = Z.mul (Z.of_int 2) (Z.mul gram_volume volume) in
      let centre = Array.map (fun row -> dot row linear) gram_adjugate in
      let common = Array.fold_left Z.gcd denominator centre in
      let common = Z.mul common (Z.of_int (Z.sign denominator)) in
      let neighbour i =
        let text, first = facet s i in
        match List.filter (fun (k', i', _) -> k' <> k || i' <> i) (Hashtbl.find_all table text) with
        | (k', _, first') :: _ -> (key k', Array.to_list (Array.map2 Z.sub first first'))
        | [] -> (key k, List.map (fun _ -> Z.zero) (Array.to_list first))
      in
      let extreme f = Array.to_list (Array.init content.dimension (fun c -> Array.fold_left (fun a v -> f a v.(c)) vertices.(0).(c) vertices)) in
      {
        volume;
        forms = Array.to_list (Array.map Array.to_list forms);
        centre_denominator = Z.divexact denominator common;
        centre = Array.to_list (Array.map (fun x -> Z.divexact x common) centre);
        neighbours = List.init (Array.length s) neighbour;
        lowest = extreme Z.min;
        highest = extreme Z.max;
      }

let hints content (d : Verified_core.certificate) : Verified_core.hints =
  let n = Array.length content.points in
  let gram_factor, least_stretch, squares = squares_of content.gram in
  let per_axis = int_of_float (float_of_int (max n 1) ** (1. /. float_of_int content.dimension)) in
  let grid : Verified_core.hints =
    { gram_factor; least_stretch; squares; cells = Z.of_int (max 1 per_axis); in_cells = Verified_core.PositiveMap.empty;
      of_simplices = Verified_core.PositiveMap.empty }
  in
  let in_cells = ref Verified_core.PositiveMap.empty in
  if Z.sign content.period > 0 then
    Array.iteri (fun label p ->
        let cell = Verified_core.cell_key grid (Verified_core.cell_of d grid (Array.to_list p)) in
        let others = match Verified_core.PositiveMap.find cell !in_cells with Some labels -> labels | None -> [] in
        in_cells := Verified_core.PositiveMap.add cell (key label :: others) !in_cells) content.points;
  let table = facet_table content in
  let gram_inverse = inverse content.gram in
  let of_simplices = map_of (Array.mapi (hints_of_simplex content gram_inverse table) content.simplices) in
  { grid with in_cells = !in_cells; of_simplices }
