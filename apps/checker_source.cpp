#include "apps/checker_source.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "support/error.hpp"

namespace delcert {

namespace {

namespace fs = std::filesystem;

constexpr const char* list_of_files = "cmake/checker-source.txt";

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  if (!stream) throw InputError(file.string() + ": cannot be read");
  return bytes;
}

fs::path root_of_source() {
  const fs::path prefix = fs::read_symlink("/proc/self/exe").parent_path().parent_path();
  for (const fs::path& root : {prefix / "share/delcert/checker-source", fs::path(DELCERT_SOURCE_FOLDER)}) {
    if (fs::exists(root / list_of_files)) return root;
  }
  throw InputError("the source of delcert-check is neither installed beside delcert nor at " DELCERT_SOURCE_FOLDER
                   "; --no-checker leaves it out");
}

}  // namespace

std::vector<ArchiveFile> checker_source() {
  const fs::path root = root_of_source();
  std::vector<ArchiveFile> files;
  const auto add = [&](const fs::path& file) {
    files.push_back({"checker/" + file.lexically_relative(root).generic_string(), bytes_of(file)});
  };
  std::ifstream list(root / list_of_files);
  for (std::string line; std::getline(list, line);) {
    if (!line.ends_with('/')) {
      add(root / line);
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(root / line)) {
      if (entry.is_regular_file()) add(entry.path());
    }
  }
  std::ranges::sort(files, {}, &ArchiveFile::name);
  return files;
}

}  // namespace delcert
