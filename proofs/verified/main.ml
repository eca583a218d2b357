(* delcert-verified FILE: decides the triangulation of a flat torus in a plain list (docs/verified.md).
   The verdict is that of the function `check`, which theorem accepted_certificates_are_delaunay is about.
   Exit status: 0 accepted, 1 not accepted, 3 unreadable, 64 wrong usage. *)

module Core = Verified_core

let list_text of_item items = String.concat " " (List.map of_item items)

(* What to say of a list that is not accepted: the first rule that fails. *)
let complaint (content : Lattice_file.content) d h =
  let simplex_text s =
    "{" ^ String.concat ", " (Array.to_list (Array.map (fun (label, z) -> string_of_int label ^ ":" ^ list_text Z.to_string (Array.to_list z)) s)) ^ "}" in
  let simplex k =
    let s = content.simplices.(k) in
    let name = Printf.sprintf "simplex %d %s" k (simplex_text s) in
    let known (label, _) = label < Array.length content.points in
    if not (Array.for_all known s) then Some (name ^ ": a label that is not in the list of points")
    else begin
      match (Core.PositiveMap.find (Lattice_file.key k) d.Core.simplices, Core.PositiveMap.find (Lattice_file.key k) h.Core.of_simplices) with
      | Some t, Some hints ->
          let vertices = List.map (Core.position d) t in
          let square = Core.square_radius d hints vertices in
          if not (Core.check_labels d (Lattice_file.key k) t) then Some (name ^ ": its labels do not increase, or are not greater than those of the simplex before it")
          else if not (Core.check_forms d hints vertices) then Some (name ^ ": its vertices are affinely dependent")
          else if not (Core.check_centre d hints vertices square) then Some (name ^ ": no circumball was found")
          else begin
            let missing = List.filter (fun i -> not (Core.check_neighbour d hints t square (Lattice_file.unary i))) (List.init (Array.length s) Fun.id) in
            match missing with
            | i :: _ ->
                Some (Printf.sprintf "%s: beyond the facet opposite its vertex %d there is no simplex whose vertex there is outside the circumball" name i)
            | [] -> if Core.check_inside d h hints t vertices then None else Some (name ^ ": a point that is not one of its vertices is in it")
          end
      | _ -> Some (name ^ ": no hints")
    end
  in
  if Z.sign content.period <= 0 then "the period is not positive"
  else if not (Core.check_metric d h) then "the Gram matrix is not symmetric and positive definite"
  else if Array.length content.simplices = 0 then "there are no simplices"
  else begin
    let rec first k = if k = Array.length content.simplices then "a rule about the whole list" else
        match simplex k with Some text -> text | None -> first (k + 1) in
    first 0
  end

let () =
  match Sys.argv with
  | [| _; ("--help" | "-h") |] ->
      print_endline "delcert-verified FILE: decides the triangulation of a flat torus in a list that `delcert export --format lattice` writes"
  | [| _; file |] -> (
      match Lattice_file.read file with
      | exception Lattice_file.Unreadable message ->
          prerr_endline ("delcert-verified: " ^ file ^ ": " ^ message);
          exit 3
      | content ->
          let d = Lattice_file.certificate content in
          let h = Hint_search.hints content d in
          if Core.check d h then
            Printf.printf "accepted: the Delaunay triangulation of %d points, %d simplices of dimension %d\n"
              (Array.length content.points) (Array.length content.simplices) content.dimension
          else begin
            Printf.printf "not accepted: %s\n" (complaint content d h);
            exit 1
          end)
  | _ ->
      prerr_endline "usage: delcert-verified FILE";
      exit 64
