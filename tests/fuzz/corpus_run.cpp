// Runs every target over its kept corpus, and over each file of it with some bytes changed, always the same.
//
// Usage: fuzz_corpus CORPUS. Prints what it ran; ends as a target does that finds something.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "tests/fuzz/targets.h"

namespace {

using namespace rouleau;

constexpr int changes_of_a_file = 40;

const std::map<std::string, void (*)(std::string_view)> targets{
    {"byte_range", fuzz::byte_range}, {"case_body", fuzz::case_body},       {"new_job", fuzz::new_job},
    {"query", fuzz::query},           {"request_head", fuzz::request_head}, {"sweep_body", fuzz::sweep_body},
    {"token_file", fuzz::token_file},
};

std::string changed(std::string text, std::mt19937& random) {
  const auto at = [&] { return text.empty() ? 0 : random() % text.size(); };
  switch (random() % 4) {
    case 0:
      text.resize(at());
      break;
    case 1:
      text.insert(at(), text.substr(at(), 16));
      break;
    case 2:
      text.erase(at(), 1 + random() % 8);
      break;
    default:
      for (int i = 0; i < 3 && !text.empty(); ++i) text[at()] = static_cast<char>(random() % 256);
  }
  return text;
}

/// How many inputs there were.
int run(void (*target)(std::string_view), const std::filesystem::path& corpus) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(corpus)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::mt19937 random(1);
  int count = 0;
  for (const auto& file : files) {
    std::ifstream stream(file, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    target(text);
    for (int i = 0; i < changes_of_a_file; ++i) target(changed(text, random));
    count += 1 + changes_of_a_file;
  }
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  for (const auto& [name, target] : targets) {
    const int count = run(target, std::filesystem::path(argv[1]) / name);
    std::cout << name << ": " << count << " inputs" << std::endl;
    if (count == 0) return 1;
  }
}
