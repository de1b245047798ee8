/* test_base_files - one file under many names: read and written, or written twice
 *
 * Every verdict is that of a child of its own: what a program has read stays known to its end.
 *
 * SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host_tools/base/files.h"
#include "host_tools/base/input.h"
#include "host_tools/base/output.h"
#include "host_tools/base/standard.h"
#include "host_tools/base/target.h"
#include "tests/test.h"

#define FOLDER TEST_FOLDER "files/"

static void make(const char *path) {
    const int fd = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    CHECK(fd >= 0 && write(fd, "old", 3) == 3, "%s: %s", path, strerror(errno));
    close(fd);
}

static void prepare(void) {
    const int status = system("rm -rf " FOLDER " && mkdir -p " FOLDER "inner");
    CHECK(status == 0, "no folder");
    make(FOLDER "file");
    CHECK(link(FOLDER "file", FOLDER "hard") == 0, "no hard link");
    CHECK(symlink("file", FOLDER "soft") == 0, "no link");
    CHECK(symlink("../soft", FOLDER "inner/chain") == 0, "no link");
    CHECK(symlink("new", FOLDER "dangling") == 0, "no link");
    CHECK(symlink("inner", FOLDER "folder") == 0, "no link");
    CHECK(symlink("../none/new", FOLDER "inner/astray") == 0, "no link");
}

static int size_of(const char *path) {
    struct stat about;
    return stat(path, &about) == 0 ? (int)about.st_size : -1;
}

/* Runs `body` on the two names in a child; its status. */
static int in_child(int (*body)(const char *, const char *), const char *one, const char *other) {
    int status = -1;
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        _exit(body(one, other));
    }
    CHECK(child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status), "no child");
    return WEXITSTATUS(status);
}

static const char *const SAME[] = {FOLDER "file",           FOLDER "./file", FOLDER "inner/../file",
                                   FOLDER "folder/../file", FOLDER "hard",   FOLDER "soft",
                                   FOLDER "inner/chain"};
enum { SAME_COUNT = sizeof SAME / sizeof SAME[0] };

enum { TAKEN = 1, REFUSED = 2, WRONG = 3 };

static int verdict_of(const output *o, const char *name, const char *word, const fail *f) {
    if (o != NULL) {
        return TAKEN;
    }
    char begin[300];
    snprintf(begin, sizeof begin, "%s: is the same file as the %s;", name, word);
    if (strncmp(f->text, begin, strlen(begin)) != 0) {
        fprintf(stderr, "    %s\n", f->text);
        return WRONG;
    }
    return REFUSED;
}

/* Reads one, then writes the other. */
static int read_then_write(const char *one, const char *other) {
    input in;
    fail f = {""};
    char word[120];
    if (input_read(&in, one, &f) != 0) {
        return WRONG;
    }
    snprintf(word, sizeof word, "input %s", one);
    return verdict_of(output_open(other, &f), other, word, &f);
}

/* Writes one, then reads the other. */
static int write_then_read(const char *one, const char *other) {
    input in;
    fail f = {""};
    output *o = output_open(one, &f);
    if (o == NULL) {
        return WRONG;
    }
    const int status = input_read(&in, other, &f);
    output_abandon(o);
    if (status == 0) {
        return TAKEN;
    }
    return strstr(f.text, "is the same file as the output") != NULL ? REFUSED : WRONG;
}

static int write_twice(const char *one, const char *other) {
    fail f = {""};
    char word[120];
    output *first = output_open(one, &f);
    snprintf(word, sizeof word, "output %s", one);
    output *second = first != NULL ? output_open(other, &f) : NULL;
    const int status = verdict_of(second, other, word, &f);
    output_abandon(second);
    output_abandon(first);
    return first != NULL ? status : WRONG;
}

static int write_after(const char *one, const char *other) {
    fail f = {""};
    output *first = output_open(one, &f);
    if (first == NULL || output_commit(first, &f) != 0) {
        return WRONG;
    }
    char word[120];
    snprintf(word, sizeof word, "output %s", one);
    output *second = output_open(other, &f);
    const int status = verdict_of(second, other, word, &f);
    output_abandon(second);
    return status;
}

/* A later read of what was written is none of these. */
static int read_after(const char *one, const char *other) {
    input in;
    fail f = {""};
    output *o = output_open(one, &f);
    if (o == NULL || output_print(o, &f, "text") != 0 || output_commit(o, &f) != 0) {
        return WRONG;
    }
    return input_read(&in, other, &f) == 0 ? TAKEN : WRONG;
}

/* With standard error going to one. */
static int with_errors(const char *one, const char *other, int (*body)(const char *)) {
    const int fd = open(one, O_WRONLY | O_APPEND);
    if (fd < 0 || dup2(fd, STDERR_FILENO) < 0) {
        return WRONG;
    }
    close(fd);
    files_open();
    return body(other);
}

static int verdict_of_errors(int status, const fail *f) {
    return status == 0                                                           ? TAKEN
           : strstr(f->text, "is the file that standard error goes to;") != NULL ? REFUSED
                                                                                 : WRONG;
}

static int read_it(const char *name) {
    input in;
    fail f = {""};
    const int status = input_read(&in, name, &f);
    return verdict_of_errors(status, &f);
}

static int write_it(const char *name) {
    fail f = {""};
    output *o = output_open(name, &f);
    output_abandon(o);
    return verdict_of_errors(o != NULL ? 0 : -1, &f);
}

static int print_it(const char *name) {
    fail f = {""};
    const int fd = open(name, O_WRONLY | O_APPEND);
    dup2(fd, STDOUT_FILENO);
    output *o = output_open_text("-", &f);
    output_abandon(o);
    return verdict_of_errors(o != NULL && output_print_standard(&f) == 0 ? 0 : -1, &f);
}

static int put_it(const char *name) {
    const int fd = open(name, O_WRONLY | O_APPEND);
    dup2(fd, STDOUT_FILENO);
    return write_it("-");
}

static int errors_and_read(const char *one, const char *other) {
    return with_errors(one, other, read_it);
}

static int errors_and_write(const char *one, const char *other) {
    return with_errors(one, other, write_it);
}

static int errors_and_print(const char *one, const char *other) {
    return with_errors(one, other, print_it);
}

static int errors_and_put(const char *one, const char *other) {
    return with_errors(one, other, put_it);
}

static void check_errors(void) {
    for (int i = 0; i < SAME_COUNT; i++) {
        CHECK(in_child(errors_and_read, FOLDER "file", SAME[i]) == REFUSED, "%s", SAME[i]);
        CHECK(in_child(errors_and_write, FOLDER "file", SAME[i]) == REFUSED, "%s", SAME[i]);
    }
    CHECK(in_child(errors_and_put, FOLDER "file", FOLDER "file") == REFUSED, "standard output");
    CHECK(in_child(errors_and_print, FOLDER "file", FOLDER "file") == TAKEN, "text there");
    CHECK(in_child(errors_and_write, FOLDER "file", FOLDER "new") == TAKEN, "another file");
    CHECK(in_child(errors_and_write, "/dev/null", "/dev/null") == TAKEN, "a device");
    CHECK(size_of(FOLDER "file") == 3, "%d bytes", size_of(FOLDER "file"));
}

static const char *const NEW[] = {FOLDER "new", FOLDER ".//new", FOLDER "folder/../new",
                                  FOLDER "dangling"};
enum { NEW_COUNT = sizeof NEW / sizeof NEW[0] };

static void every_pair(void) {
    for (int i = 0; i < SAME_COUNT; i++) {
        for (int k = 0; k < SAME_COUNT; k++) {
            CHECK(in_child(read_then_write, SAME[i], SAME[k]) == REFUSED, "%s, %s", SAME[i],
                  SAME[k]);
            CHECK(in_child(write_then_read, SAME[i], SAME[k]) == REFUSED, "%s, %s", SAME[i],
                  SAME[k]);
            CHECK(in_child(write_twice, SAME[i], SAME[k]) == REFUSED, "%s, %s", SAME[i], SAME[k]);
        }
    }
    for (int i = 0; i < NEW_COUNT; i++) {
        for (int k = 0; k < NEW_COUNT; k++) {
            CHECK(in_child(write_twice, NEW[i], NEW[k]) == REFUSED, "%s, %s", NEW[i], NEW[k]);
        }
    }
    CHECK(size_of(FOLDER "file") == 3 && size_of(FOLDER "new") == -1, "something was written");
}

static void every_other(void) {
    CHECK(in_child(read_then_write, FOLDER "file", FOLDER "new") == TAKEN, "another file");
    CHECK(in_child(write_then_read, FOLDER "new", FOLDER "file") == TAKEN, "another file");
    CHECK(in_child(write_twice, FOLDER "file", FOLDER "new") == TAKEN, "another file");
    CHECK(in_child(write_twice, FOLDER "new", FOLDER "inner/new") == TAKEN, "another folder");
    CHECK(in_child(write_twice, "/dev/null", "/dev/null") == TAKEN, "a device");
    CHECK(in_child(write_after, FOLDER "inner/new", FOLDER "inner/new") == TAKEN, "one by one");
    CHECK(in_child(write_after, FOLDER "inner/file", FOLDER "inner/new") == TAKEN, "two files");
    CHECK(in_child(write_after, "/dev/null", "/dev/null") == TAKEN, "a device");
    CHECK(in_child(read_after, FOLDER "inner/new", FOLDER "inner/new") == TAKEN, "read back");
}

static void check_finished(void) {
    CHECK(symlink("other", FOLDER "inner/later") == 0, "no link");
    CHECK(in_child(write_after, FOLDER "inner/other", FOLDER "inner/later") == REFUSED, "a link");
    CHECK(in_child(write_after, FOLDER "inner/later", FOLDER "folder/other") == REFUSED, "to it");
}

static void keep_standard_output(void (*body)(void)) {
    fflush(stdout);
    const int kept = dup(STDOUT_FILENO);
    body();
    fflush(stdout);
    dup2(kept, STDOUT_FILENO);
    close(kept);
}

static int standard_status[3];

static void redirect(void) {
    const int fd = open(FOLDER "file", O_WRONLY | O_APPEND);
    dup2(fd, STDOUT_FILENO);
    close(fd);
    standard_status[0] = in_child(write_twice, FOLDER "soft", "-");
    standard_status[1] = in_child(write_twice, FOLDER "new", "-");
    standard_status[2] = in_child(write_twice, "-", FOLDER "hard");
}

/* A name that the child calls "standard output" is no verdict_of here: only taken or not. */
static void check_standard(void) {
    keep_standard_output(redirect);
    CHECK(standard_status[0] != TAKEN, "taken: %d", standard_status[0]);
    CHECK(standard_status[1] == TAKEN, "not taken: %d", standard_status[1]);
    CHECK(standard_status[2] != TAKEN, "taken: %d", standard_status[2]);
    CHECK(size_of(FOLDER "file") == 3, "%d bytes", size_of(FOLDER "file"));
}

static int read_many(const char *one, const char *other) {
    char path[120];
    fail f = {""};
    for (int i = 0; i < 3000; i++) {
        snprintf(path, sizeof path, "%s%d", one, i);
        const int fd = open(path, O_RDWR | O_CREAT, 0666);
        if (fd < 0 || files_read(fd, path, &f) != 0 || files_read(fd, other, &f) != 0) {
            return WRONG;
        }
        close(fd);
    }
    for (int i = 0; i < 3000; i++) {
        char word[140];
        snprintf(path, sizeof path, "%s%d", one, i);
        snprintf(word, sizeof word, "input %s", path);
        fail g = {""};
        if (verdict_of(output_open(path, &g), path, word, &g) != REFUSED) {
            return WRONG;
        }
    }
    return output_open(other, &f) != NULL ? TAKEN : WRONG;
}

static void check_targets(void) {
    static const char *const pairs[][2] = {{FOLDER "file", FOLDER "file"},
                                           {FOLDER "none", FOLDER "none"},
                                           {FOLDER "soft", FOLDER "file"},
                                           {FOLDER "dangling", FOLDER "new"},
                                           {FOLDER "inner/chain", FOLDER "inner/../file"},
                                           {FOLDER "inner/astray", FOLDER "inner/../none/new"},
                                           {FOLDER "folder/chain", FOLDER "folder/../file"}};
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        char *target = target_of(pairs[i][0]);
        CHECK(target != NULL && strcmp(target, pairs[i][1]) == 0, "%s: %s", pairs[i][0],
              target != NULL ? target : strerror(errno));
        free(target);
    }
    CHECK(symlink("/absolute/one", FOLDER "absolute") == 0, "no link");
    char *target = target_of(FOLDER "absolute");
    CHECK(target != NULL && strcmp(target, "/absolute/one") == 0, "%s", target ? target : "none");
    free(target);
    CHECK(symlink("ring", FOLDER "ring") == 0, "no link");
    errno = 0;
    CHECK(target_of(FOLDER "ring") == NULL && errno == ELOOP, "a ring: %s", strerror(errno));
}

/* Closes what the bits of `closed` say, then opens files. */
static int open_without(const char *closed, const char *path) {
    for (int fd = 0; fd <= 2; fd++) {
        if (strchr(closed, '0' + fd) != NULL) {
            close(fd);
        }
    }
    if (standard_open() != 0) {
        return WRONG;
    }
    const int fd = open(path, O_RDONLY);
    char byte;
    for (int i = 0; i <= 2; i++) {
        const int is_closed = strchr(closed, '0' + i) != NULL;
        const int can = i == 0 ? standard_can_read(i) : standard_can_write(i);
        const ssize_t done = i == 0 ? 0 : write(i, "", 0);
        if (can == is_closed || (is_closed && errno != EBADF) ||
            (is_closed && done == 0 && i > 0)) {
            return WRONG;
        }
    }
    return fd > 2 && (strchr(closed, '0') == NULL || read(0, &byte, 1) == -1) ? TAKEN : WRONG;
}

static void check_closed(void) {
    static const char *const sets[] = {"", "0", "1", "2", "01", "02", "12", "012"};
    for (size_t i = 0; i < sizeof sets / sizeof sets[0]; i++) {
        CHECK(in_child(open_without, sets[i], FOLDER "file") == TAKEN, "without %s", sets[i]);
    }
}

int main(void) {
    test("a file is one under every name: not read and written, not written twice");
    prepare();
    every_pair();
    test("a file that was written is not written again under another name");
    check_finished();
    test("standard error is no input and no output, but for text on standard output");
    check_errors();
    test("other files, and devices, are others");
    every_other();
    test("standard output is the file it is redirected to");
    check_standard();
    test("thousands of files that were read are all known");
    CHECK(in_child(read_many, FOLDER "inner/n", FOLDER "new") == TAKEN, "not all");
    test("links are followed also to what does not exist");
    check_targets();
    test("streams that were closed fail as if they were, and no file takes their number");
    check_closed();
    CHECK(system("rm -rf " FOLDER) == 0, "not removed");
    return test_done();
}
