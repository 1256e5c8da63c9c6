#include "service/commands/command.h"

int main(int argc, char** argv) {
  return rouleau::service::run_command_line(argc, argv);
}
