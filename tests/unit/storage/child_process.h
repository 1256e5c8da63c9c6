#pragma once

#include <cstdlib>
#include <exception>
#include <functional>
#include <signal.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace rouleau::storage {

/// A forked child that reports lines over a pipe. Fork before any thread is started.
class ChildProcess {
 public:
  using Tell = std::function<void(const std::string& line)>;

  explicit ChildProcess(const std::function<void(const Tell&)>& body) {
    int ends[2];
    if (pipe(ends) != 0) std::abort();
    pid_ = fork();
    if (pid_ == 0) {
      close(ends[0]);
      const Tell tell = [&](const std::string& line) {
        const std::string text = line + "\n";
        if (write(ends[1], text.data(), text.size()) < 0) _exit(3);
      };
      try {
        body(tell);
      } catch (const std::exception& error) {
        tell(std::string("exception: ") + error.what());
        _exit(1);
      }
      _exit(0);
    }
    close(ends[1]);
    output_ = ends[0];
  }
  ~ChildProcess() {
    kill();
    close(output_);
  }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  pid_t pid() const { return pid_; }

  /// Ends it on the spot, as `kill -9` does.
  void kill() {
    if (ended_) return;
    ::kill(pid_, SIGKILL);
    wait();
  }

  int wait() {
    int status = 0;
    if (!ended_) waitpid(pid_, &status, 0);
    ended_ = true;
    return status;
  }

  /// The next line, without its end; empty when the child has closed its end.
  std::string read_line() {
    std::string line;
    char c = 0;
    while (read(output_, &c, 1) == 1 && c != '\n') line += c;
    return line;
  }

  /// What is left of the output.
  std::string read_all() {
    std::string text;
    char c = 0;
    while (read(output_, &c, 1) == 1) text += c;
    return text;
  }

 private:
  pid_t pid_ = -1;
  int output_ = -1;
  bool ended_ = false;
};

}  // namespace rouleau::storage
