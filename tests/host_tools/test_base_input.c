/* test_base_input - whole files in memory, and what is refused
 *
 * SPDX-License-Identifier: MIT */
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host_tools/base/input.h"
#include "tests/test.h"

#define FOLDER TEST_FOLDER "input/"
#define FILE_NAME FOLDER "file"

static void make_folder(void) {
    mkdir(TEST_FOLDER, 0777);
    mkdir(FOLDER, 0777);
}

/* `size` bytes, each different from its neighbours. */
static unsigned char *pattern(size_t size) {
    unsigned char *bytes = malloc(size + 1);
    for (size_t i = 0; i < size; i++) {
        bytes[i] = (unsigned char)(i * 7 + (i >> 8));
    }
    return bytes;
}

static void write_bytes(int fd, const unsigned char *bytes, size_t size) {
    while (size > 0) {
        const ssize_t done = write(fd, bytes, size);
        if (done <= 0) {
            return;
        }
        bytes += done;
        size -= (size_t)done;
    }
}

static void check_pattern(const char *path, const char *from, size_t size) {
    input in;
    fail f = {{0}};
    unsigned char *bytes = pattern(size);
    CHECK(input_read(&in, path, &f) == 0, "%s %zu: %s", from, size, f.text);
    CHECK(in.size == size, "%s: %zu bytes, not %zu", from, in.size, size);
    CHECK(in.size == size && memcmp(in.bytes, bytes, size) == 0, "%s %zu: bytes differ", from,
          size);
    CHECK(in.size == size && in.bytes[size] == 0, "%s %zu: no zero byte after it", from, size);
    input_free(&in);
    CHECK(in.bytes == NULL && in.size == 0, "not freed");
    free(bytes);
}

static const size_t SIZES[] = {1, 2, 4095, 65535, 65536, 65537, 131072, 1000003};
enum { SIZE_COUNT = sizeof SIZES / sizeof SIZES[0] };

static void write_file(size_t size) {
    unsigned char *bytes = pattern(size);
    const int fd = open(FILE_NAME, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    write_bytes(fd, bytes, size);
    close(fd);
    free(bytes);
}

static void reads_files(void) {
    test("Files of any size are read whole, with a zero byte after the last");
    for (int i = 0; i < SIZE_COUNT; i++) {
        write_file(SIZES[i]);
        check_pattern(FILE_NAME, "file", SIZES[i]);
    }
}

/* Standard input becomes a pipe that a child fills with `size` bytes. */
static pid_t pipe_in(size_t size) {
    int ends[2];
    if (pipe(ends) != 0) {
        return -1;
    }
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        write_bytes(ends[1], pattern(size), size);
        _exit(0);
    }
    dup2(ends[0], STDIN_FILENO);
    close(ends[0]);
    close(ends[1]);
    return child;
}

static void reads_pipes(void) {
    test("Pipes of any length are read whole from standard input");
    for (int i = 0; i < SIZE_COUNT; i++) {
        const pid_t child = pipe_in(SIZES[i]);
        check_pattern("-", "pipe", SIZES[i]);
        waitpid(child, NULL, 0);
    }
}

static void reads_redirected(void) {
    test("A file redirected to standard input is read from where it stands");
    write_file(70000);
    const int fd = open(FILE_NAME, O_RDONLY);
    dup2(fd, STDIN_FILENO);
    close(fd);
    check_pattern("-", "redirected", 70000);
}

static void reads_sizeless(void) {
    test("A file that says it has 0 bytes but has some is read");
    input in;
    fail f = {{0}};
    CHECK(input_read(&in, "/proc/self/status", &f) == 0, "%s", f.text);
    CHECK(in.size > 100 && memcmp(in.bytes, "Name:", 5) == 0, "%zu bytes", in.size);
    input_free(&in);
}

static void must_refuse(const char *path, const char *expected) {
    input in;
    fail f = {{0}};
    CHECK(input_read(&in, path, &f) == -1, "read %s", path);
    CHECK(strcmp(f.text, expected) == 0, "said '%s', not '%s'", f.text, expected);
    CHECK(in.bytes == NULL && in.size == 0, "bytes left");
}

static void refuses(void) {
    test("What cannot be read is refused with a remedy");
    write_file(0);
    must_refuse(FILE_NAME, FILE_NAME ": is empty; write the file again");
    must_refuse("build", "build: is a directory; name a file in it");
    must_refuse("build/none",
                "build/none: cannot open: No such file or directory; "
                "check the spelling and the directory you are in");
    must_refuse(FILE_NAME "/x", FILE_NAME
                "/x: cannot open: Not a directory; "
                "check the spelling and the directory you are in");
    must_refuse("", "the input has no name; give one, or - for standard input");
    must_refuse("/dev/zero", "/dev/zero: is a device; name a file, or - for standard input");
    waitpid(pipe_in(0), NULL, 0);
    must_refuse("-", "standard input: is empty; write the file again");
    close(STDIN_FILENO);
    must_refuse("-",
                "standard input: cannot open: Bad file descriptor; "
                "the stream is closed: redirect a file to it");
}

static void refuses_holes(void) {
    test("A file with holes larger than the memory is refused before it is read");
    const int fd = open(FILE_NAME, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    const int made = ftruncate(fd, (off_t)1 << 43) == 0;
    close(fd);
    input in;
    fail f = {{0}};
    CHECK(made, "the file system has no files of 8 TiB: build on another one");
    CHECK(input_read(&in, FILE_NAME, &f) == -1, "read");
    CHECK(strcmp(f.text, FILE_NAME ": 8796093022208 bytes do not fit into memory; "
                                   "split the file or use a larger machine") == 0,
          "%s", f.text);
    unlink(FILE_NAME);
}

static void without_rights(void) {
    if (geteuid() == 0 && setuid(65534) != 0) {
        _exit(1);
    }
    input in;
    fail f = {{0}};
    const int result = input_read(&in, FILE_NAME, &f);
    _exit(result == -1 && strcmp(f.text, FILE_NAME ": cannot open: Permission denied; make it "
                                                   "readable with chmod +r, or run as its "
                                                   "owner") == 0
              ? 7
              : 2);
}

static void refuses_rights(void) {
    test("A file without read permission is refused with a remedy");
    write_file(10);
    CHECK(chmod(FILE_NAME, 0) == 0, "not changed");
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        without_rights();
    }
    int status = -1;
    CHECK(waitpid(child, &status, 0) == child, "no child");
    CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 7, "status %x", status);
    unlink(FILE_NAME);
}

int main(void) {
    make_folder();
    reads_files();
    reads_pipes();
    reads_redirected();
    reads_sizeless();
    refuses();
    refuses_holes();
    refuses_rights();
    return test_done();
}
