// read_simplex_tree FILE: what GUDHI's own reader makes of it: the numbers of vertices and of simplices, and the
// dimension.
#include <gudhi/Simplex_tree.h>

#include <fstream>
#include <iostream>

int main(int argc, char** argv) {
  if (argc != 2) return 64;
  std::ifstream in(argv[1]);
  Gudhi::Simplex_tree<> tree;
  in >> tree;
  std::cout << tree.num_vertices() << " " << tree.num_simplices() << " " << tree.dimension() << "\n";
  return 0;
}
