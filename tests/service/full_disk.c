/* A disk that is full from a certain write on, for a program that has this preloaded: whatever would take room in
 * the folder FULL_DISK_FOLDER then fails with ENOSPC. The file FULL_DISK_CONTROL has three 64-bit numbers, shared with
 * the test: how many such calls there were, from which on they fail (0: none does), and how many have failed. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/sendfile.h>
#include <sys/uio.h>
#include <unistd.h>

struct control {
  int64_t calls, full_from, failed;
};

static struct control* control;
static const char* folder;

__attribute__((constructor)) static void open_control(void) {
  folder = getenv("FULL_DISK_FOLDER");
  const char* path = getenv("FULL_DISK_CONTROL");
  const int descriptor = path == NULL || folder == NULL ? -1 : open(path, O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return;
  void* shared = mmap(NULL, sizeof *control, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  if (shared != MAP_FAILED) control = shared;
  close(descriptor);
}

static int in_folder(int descriptor) {
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length <= 0) return 0;
  path[length] = 0;
  return strncmp(path, folder, strlen(folder)) == 0;
}

static int is_full(int descriptor) {
  if (control == NULL || !in_folder(descriptor)) return 0;
  const int64_t call = __atomic_add_fetch(&control->calls, 1, __ATOMIC_SEQ_CST);
  const int64_t from = __atomic_load_n(&control->full_from, __ATOMIC_SEQ_CST);
  if (from == 0 || call < from) return 0;
  __atomic_add_fetch(&control->failed, 1, __ATOMIC_SEQ_CST);
  errno = ENOSPC;
  return 1;
}

#define REFUSING(result, name, descriptor, parameters, arguments)              \
  result name parameters {                                                     \
    static result(*next) parameters;                                           \
    if (next == NULL) *(void**)&next = dlsym(RTLD_NEXT, #name);                \
    return is_full(descriptor) ? (result)-1 : next arguments;                  \
  }

REFUSING(ssize_t, write, file, (int file, const void* data, size_t size), (file, data, size))
REFUSING(ssize_t, pwrite, file, (int file, const void* data, size_t size, off_t at), (file, data, size, at))
REFUSING(ssize_t, pwrite64, file, (int file, const void* data, size_t size, off64_t at), (file, data, size, at))
REFUSING(ssize_t, writev, file, (int file, const struct iovec* parts, int count), (file, parts, count))
REFUSING(ssize_t, sendfile, to, (int to, int from, off_t* at, size_t size), (to, from, at, size))
REFUSING(ssize_t, sendfile64, to, (int to, int from, off64_t* at, size_t size), (to, from, at, size))
REFUSING(ssize_t, copy_file_range, to,
         (int from, off64_t* from_at, int to, off64_t* to_at, size_t size, unsigned flags),
         (from, from_at, to, to_at, size, flags))
REFUSING(int, ftruncate, file, (int file, off_t size), (file, size))
REFUSING(int, ftruncate64, file, (int file, off64_t size), (file, size))
REFUSING(int, fallocate, file, (int file, int mode, off_t at, off_t size), (file, mode, at, size))
REFUSING(int, fallocate64, file, (int file, int mode, off64_t at, off64_t size), (file, mode, at, size))
REFUSING(int, fsync, file, (int file), (file))
REFUSING(int, fdatasync, file, (int file), (file))
