#pragma once

#include <filesystem>
#include <mutex>
#include <optional>

#include "engine/plan/machine.h"

namespace rouleau::service {

/// Where data lies unless it is said: XDG_DATA_HOME/rouleau, or ~/.local/share/rouleau.
std::filesystem::path default_data_folder();

/// The one that ROULEAU_DATA names, or else the default.
std::filesystem::path data_folder();

/// The speed of this machine. It is measured once and kept in a file: ROULEAU_MACHINE, or `machine.json` in
/// the data folder. Measured again if the engine or the processor is another one.
class KnownMachine {
 public:
  explicit KnownMachine(const std::filesystem::path& data_folder);

  const std::filesystem::path& file() const { return file_; }

  /// What the file says; nothing if it is missing, damaged, or about another engine or processor.
  std::optional<Machine> kept() const;

  /// Without measuring anything: what this process knows or the file says, else a machine like any other.
  Machine known();

  /// As it is kept. Measures it first if it is not, which takes half a second; others wait for that.
  Machine get();

  /// Measures and keeps it. A folder that cannot be written to is no error: it is then measured anew each
  /// time.
  Machine measure();

 private:
  Machine measure_and_keep();

  std::filesystem::path file_;
  std::mutex mutex_;
  std::optional<Machine> machine_;  ///< once it is known to this process
};

}  // namespace rouleau::service
