(* The plain list that `delcert export --format lattice` writes (docs/verified.md): integers, white space between them,
   comments from # to the end of the line. Nothing is computed here. *)

exception Unreadable of string

type content = {
  dimension : int;
  period : Z.t;
  gram : Z.t array array;
  points : Z.t array array;
  simplices : (int * Z.t array) array array;  (* label, lattice vector *)
}

type words = { channel : in_channel; mutable line : int; mutable rest : string list }

let unreadable words what = raise (Unreadable (Printf.sprintf "line %d: %s" words.line what))

let rec next words =
  match words.rest with
  | word :: rest ->
      words.rest <- rest;
      word
  | [] -> (
      match input_line words.channel with
      | exception End_of_file -> unreadable words "the file ends here"
      | line ->
          words.line <- words.line + 1;
          let line = match String.index_opt line '#' with Some k -> String.sub line 0 k | None -> line in
          words.rest <- List.filter (fun word -> word <> "") (String.split_on_char ' ' line);
          next words)

let rec is_at_end words =
  words.rest = []
  &&
  match input_line words.channel with
  | exception End_of_file -> true
  | line ->
      words.line <- words.line + 1;
      let line = match String.index_opt line '#' with Some k -> String.sub line 0 k | None -> line in
      words.rest <- List.filter (fun word -> word <> "") (String.split_on_char ' ' line);
      is_at_end words

let expect words keyword =
  let word = next words in
  if word <> keyword then unreadable words (Printf.sprintf "%S, where %S was expected" word keyword)

(* Decimal digits with an optional minus sign; nothing else that Z.of_string reads. *)
let integer words =
  let word = next words in
  let digits = if word.[0] = '-' then String.sub word 1 (String.length word - 1) else word in
  if digits = "" || not (String.for_all (fun c -> '0' <= c && c <= '9') digits) then
    unreadable words (Printf.sprintf "%S is not an integer" word);
  Z.of_string word

let count words ~least ~most what =
  let value = integer words in
  if Z.lt value (Z.of_int least) || Z.gt value (Z.of_int most) then
    unreadable words (Printf.sprintf "%s is not between %d and %d" what least most);
  Z.to_int value

let most = 100_000_000

let array n f =
  if n = 0 then [||]
  else begin
    let result = Array.make n (f ()) in
    for k = 1 to n - 1 do
      result.(k) <- f ()
    done;
    result
  end

let read_words words =
  expect words "delcert-lattice";
  expect words "1";
  expect words "dimension";
  let dimension = count words ~least:1 ~most:16 "the dimension" in
  let vector () = array dimension (fun () -> integer words) in
  expect words "period";
  let period = integer words in
  expect words "gram";
  let gram = array dimension vector in
  expect words "points";
  let n = count words ~least:0 ~most "the number of points" in
  let points = array n vector in
  expect words "simplices";
  let k = count words ~least:0 ~most "the number of simplices" in
  let vertex () =
    let label = count words ~least:0 ~most "a label" in
    let shift = vector () in
    (label, shift)
  in
  let simplices = array k (fun () -> array (dimension + 1) vertex) in
  if not (is_at_end words) then unreadable words "more than the simplices that were announced";
  { dimension; period; gram; points; simplices }

let read file =
  match open_in file with
  | exception Sys_error message -> raise (Unreadable message)
  | channel ->
      Fun.protect ~finally:(fun () -> close_in channel) (fun () -> read_words { channel; line = 0; rest = [] })

let rec unary k = if k = 0 then Verified_core.O else Verified_core.S (unary (k - 1))

(* Labels and places in lists count from 0; the keys of the maps of the core from 1. *)
let key k = Z.of_int (k + 1)

let map_of values = snd (Array.fold_left (fun (k, map) value -> (k + 1, Verified_core.PositiveMap.add (key k) value map)) (0, Verified_core.PositiveMap.empty) values)

let certificate content : Verified_core.certificate =
  let vector = Array.to_list in
    {
    dimension = unary content.dimension;
    period = content.period;
    gram = Array.to_list (Array.map vector content.gram);
    points = map_of (Array.map vector content.points);
    simplices =
      map_of (Array.map (fun s -> Array.to_list (Array.map (fun (label, shift) -> (key label, vector shift)) s)) content.simplices);
  }
