/* test_base_output - files that appear whole or not at all, and failures
 *
 * SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host_tools/base/output.h"
#include "tests/test.h"

#define FOLDER TEST_FOLDER "output/"
#define TARGET FOLDER "target"

static void remove_all(void) {
    DIR *folder = opendir(FOLDER);
    for (struct dirent *e = folder ? readdir(folder) : NULL; e; e = readdir(folder)) {
        char path[600];
        snprintf(path, sizeof path, FOLDER "%s", e->d_name);
        if (strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0) {
            remove(path);
        }
    }
    if (folder) {
        closedir(folder);
    }
}

static void clean(void) {
    mkdir(TEST_FOLDER, 0777);
    mkdir(FOLDER, 0777);
    remove_all();
}

/* Entries of the folder; -1 when it cannot be read. */
static int entries(void) {
    DIR *folder = opendir(FOLDER);
    int count = folder ? 0 : -1;
    for (struct dirent *e = folder ? readdir(folder) : NULL; e; e = readdir(folder)) {
        count += strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0;
    }
    if (folder) {
        closedir(folder);
    }
    return count;
}

/* The file's size, or -1. */
static long size_of(const char *path) {
    struct stat about;
    return stat(path, &about) == 0 ? (long)about.st_size : -1;
}

static int holds(const char *path, const char *text) {
    char bytes[256] = {0};
    FILE *file = fopen(path, "rb");
    const size_t size = file ? fread(bytes, 1, sizeof bytes - 1, file) : 0;
    if (file) {
        fclose(file);
    }
    return file && size == strlen(text) && memcmp(bytes, text, size) == 0;
}

/* The library knows to its end what it has written: while the file is open, its number goes to
 * no other one, also when it is deleted. */
static void stays_known(const char *path) {
    open(path, O_RDONLY | O_NONBLOCK);
}

static int write_file(const char *path, const char *text, fail *f) {
    output *o = output_open(path, f);
    if (!o) {
        return -1;
    }
    if (output_write(o, text, strlen(text), f) != 0) {
        output_abandon(o);
        return -1;
    }
    const int status = output_commit(o, f);
    return status == 0 ? (stays_known(path), 0) : status;
}

/* What was there before. */
static void make_file(const char *path, const char *text) {
    FILE *file = fopen(path, "wb");
    CHECK(file && fputs(text, file) >= 0 && fclose(file) == 0, "not made");
}

static void appears_whole(void) {
    test("A file appears at commit, whole, and nothing stays beside it");
    clean();
    fail f = {{0}};
    output *o = output_open(TARGET, &f);
    CHECK(o != NULL, "%s", f.text);
    for (int i = 0; o && i < 100000; i++) {
        CHECK(output_print(o, &f, "%07d\n", i) == 0, "%s", f.text);
    }
    CHECK(size_of(TARGET) == -1, "there before the commit");
    CHECK(entries() == 1, "%d entries", entries());
    CHECK(o && output_commit(o, &f) == 0, "%s", f.text);
    stays_known(TARGET);
    CHECK(size_of(TARGET) == 800000, "%ld bytes", size_of(TARGET));
    CHECK(entries() == 1, "%d entries", entries());
    char line[9] = {0};
    FILE *file = fopen(TARGET, "rb");
    for (int i = 0; file && i < 100000; i++) {
        char expected[24];
        snprintf(expected, sizeof expected, "%07d\n", i);
        CHECK(fread(line, 1, 8, file) == 8 && strcmp(line, expected) == 0, "line %d", i);
    }
    CHECK(file && fclose(file) == 0, "not read");
}

static void writes_any_length(void) {
    test("Blocks and prints around the buffer's size arrive in order");
    clean();
    static char block[200000];
    memset(block, 'x', sizeof block - 1);
    fail f = {{0}};
    const size_t sizes[] = {0, 1, 65535, 65536, 65537, 199999, 1024, 1023};
    size_t total = 0;
    output *o = output_open(TARGET, &f);
    for (size_t i = 0; o && i < sizeof sizes / sizeof sizes[0]; i++) {
        CHECK(output_write(o, block, sizes[i], &f) == 0, "%s", f.text);
        CHECK(output_print(o, &f, "%.*s", (int)sizes[i], block) == 0, "%s", f.text);
        total += 2 * sizes[i];
    }
    CHECK(o && output_commit(o, &f) == 0, "%s", f.text);
    stays_known(TARGET);
    CHECK(size_of(TARGET) == (long)total, "%ld bytes, not %zu", size_of(TARGET), total);
}

static void abandons(void) {
    test("An abandoned file leaves the old one, and nothing beside it");
    clean();
    fail f = {{0}};
    make_file(TARGET, "old");
    output *o = output_open(TARGET, &f);
    CHECK(o && output_write(o, "new", 3, &f) == 0, "%s", f.text);
    output_abandon(o);
    output_abandon(NULL);
    CHECK(holds(TARGET, "old") && entries() == 1, "%d entries", entries());
    CHECK(write_file(TARGET, "new", &f) == 0, "%s", f.text);
    CHECK(holds(TARGET, "new") && entries() == 1, "%d entries", entries());
}

static void keeps_modes(void) {
    test("A replaced file keeps its mode, a new one gets the usual one, a link stays a link");
    clean();
    fail f = {{0}};
    struct stat about;
    const mode_t mask = umask(027);
    CHECK(write_file(FOLDER "new", "one", &f) == 0, "%s", f.text);
    umask(mask);
    CHECK(stat(FOLDER "new", &about) == 0 && (about.st_mode & 0777) == 0640, "mode %o",
          about.st_mode);
    make_file(TARGET, "one");
    CHECK(chmod(TARGET, 0604) == 0 && symlink("target", FOLDER "link") == 0, "no link");
    CHECK(write_file(FOLDER "link", "two", &f) == 0, "%s", f.text);
    CHECK(stat(TARGET, &about) == 0 && (about.st_mode & 0777) == 0604, "mode %o", about.st_mode);
    CHECK(lstat(FOLDER "link", &about) == 0 && S_ISLNK(about.st_mode), "the link is gone");
    CHECK(holds(TARGET, "two") && entries() == 3, "%d entries", entries());
}

/* Runs `body` in a child; what `wait` says about its end. */
static int in_child(void (*body)(void)) {
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        body();
        exit(0);
    }
    int status = -1;
    CHECK(child > 0 && waitpid(child, &status, 0) == child, "no child");
    return status;
}

static int ending_signal;

static void open_and_end(void) {
    fail f = {{0}};
    output *first = output_open(TARGET, &f), *second = output_open(FOLDER "second", &f);
    output *third = output_open(FOLDER "third", &f);
    if (!first || !second || !third || entries() != 3) {
        _exit(9);
    }
    output_abandon(second);
    if (ending_signal) {
        raise(ending_signal);
    }
    exit(3);
}

#if defined(__SANITIZE_ADDRESS__)
enum { CRASH = 0 }; /* the sanitizer takes it for itself */
#else
enum { CRASH = SIGBUS };
#endif

static void removed_at_end(void) {
    test("Exit and every signal that can be caught remove what was not committed");
    const int numbers[] = {0,       SIGINT,  SIGTERM, SIGHUP,    SIGPIPE, SIGQUIT, SIGALRM,
                           SIGUSR1, SIGUSR2, SIGXCPU, SIGVTALRM, SIGPROF, SIGSYS,  CRASH};
    const struct rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        clean();
        ending_signal = numbers[i];
        const int status = in_child(open_and_end);
        if (ending_signal) {
            CHECK(WIFSIGNALED(status) && WTERMSIG(status) == ending_signal, "status %x", status);
        } else {
            CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 3, "status %x", status);
        }
        CHECK(entries() == 0, "%d entries after signal %d", entries(), ending_signal);
    }
}

static void ignore_and_end(void) {
    signal(SIGHUP, SIG_IGN);
    fail f = {{0}};
    output *o = output_open(TARGET, &f);
    raise(SIGHUP);
    exit(o && output_write(o, "on", 2, &f) == 0 && output_commit(o, &f) == 0 ? 4 : 5);
}

static void respects_nohup(void) {
    test("A signal that was ignored before (nohup) stays ignored");
    clean();
    const int status = in_child(ignore_and_end);
    CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 4, "status %x", status);
    CHECK(holds(TARGET, "on") && entries() == 1, "%d entries", entries());
}

static void exit_at_once(void) {
    exit(0);
}

static void child_removes_nothing(void) {
    test("A forked child that exits leaves its parent's file alone");
    clean();
    fail f = {{0}};
    output *o = output_open(TARGET, &f);
    CHECK(o && output_write(o, "kept", 4, &f) == 0, "%s", f.text);
    in_child(exit_at_once);
    CHECK(o && output_commit(o, &f) == 0, "%s", f.text);
    stays_known(TARGET);
    CHECK(holds(TARGET, "kept"), "lost");
}

static void must_refuse(const char *path, const char *expected) {
    fail f = {{0}};
    output *o = output_open(path, &f);
    CHECK(o == NULL, "opened %s", path);
    CHECK(strcmp(f.text, expected) == 0, "said '%s', not '%s'", f.text, expected);
    output_abandon(o);
}

static void refuses_names(void) {
    test("Directories, missing ones and bad names are refused with a remedy");
    clean();
    must_refuse("", "the output has no name; give one, or - for standard output");
    must_refuse("build", "build: is a directory; name a file in it");
    must_refuse(FOLDER, FOLDER ": is a directory; name a file in it");
    must_refuse("build/none/",
                "build/none/: there is no such directory; create it and name a file in it");
    must_refuse("build/none/file",
                "build/none/file: cannot create a file there: No such file or "
                "directory; create the directory first, or correct the path");
    make_file(TARGET, "x");
    must_refuse(TARGET "/file", TARGET
                "/file: cannot open it: Not a directory; "
                "create the directory first, or correct the path");
    CHECK(entries() == 1, "%d entries", entries());
}

static void without_rights(void) {
    if (geteuid() == 0 && setuid(65534) != 0) {
        _exit(1);
    }
    fail f = {{0}}, g = {{0}};
    if (output_open(FOLDER "locked/file", &f) || output_open(TARGET, &g)) {
        _exit(2);
    }
    _exit(strcmp(f.text, FOLDER "locked/file: cannot create a file there: Permission denied; "
                                "write to a directory you own, or change its permissions") != 0 ||
                  strcmp(g.text, TARGET ": is write-protected; "
                                        "choose another name or chmod u+w it") != 0
              ? 3
              : 7);
}

static void refuses_rights(void) {
    test("A directory without rights and a write-protected file are refused");
    clean();
    make_file(TARGET, "x");
    CHECK(chmod(TARGET, 0444) == 0 && mkdir(FOLDER "locked", 0555) == 0, "not made");
    const int status = in_child(without_rights);
    CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 7, "status %x", status);
    CHECK(holds(TARGET, "x"), "changed");
}

static void full_disk(void) {
    test("A full disk is said at the write or at the commit, and stays said");
    fail f = {{0}};
    const char *expected =
        "/dev/full: cannot write: No space left on device; "
        "free some space or write to another disk";
    CHECK(write_file("/dev/full", "little", &f) == -1, "written");
    CHECK(strcmp(f.text, expected) == 0, "%s", f.text);
    static char block[300000];
    fail g = {{0}}, h = {{0}}, i = {{0}};
    output *o = output_open("/dev/full", &g);
    CHECK(o && output_write(o, block, sizeof block, &g) == -1, "written");
    CHECK(strcmp(g.text, expected) == 0, "%s", g.text);
    CHECK(o && output_write(o, "x", 1, &h) == -1 && strcmp(h.text, expected) == 0, "%s", h.text);
    CHECK(o && output_commit(o, &i) == -1 && strcmp(i.text, expected) == 0, "%s", i.text);
}

static void over_the_limit(void) {
    const struct rlimit limit = {100000, 100000};
    setrlimit(RLIMIT_FSIZE, &limit);
    static char block[300000];
    fail f = {{0}};
    output *o = output_open(TARGET, &f);
    const int written = o ? output_write(o, block, sizeof block, &f) : -2;
    const int committed = o ? output_commit(o, &f) : -2;
    _exit(written == -1 && committed == -1 &&
                  strcmp(f.text,
                         TARGET ": cannot write: File too large; "
                                "the file size limit is reached: raise it with ulimit -f") == 0
              ? 7
              : 1);
}

static void size_limit(void) {
    test("The file size limit is a failure with a remedy, and leaves the old file");
    clean();
    make_file(TARGET, "old");
    const int status = in_child(over_the_limit);
    CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 7, "status %x", status);
    CHECK(holds(TARGET, "old") && entries() == 1, "%d entries", entries());
}

static void write_to_fifo(void) {
    fail f = {{0}};
    exit(write_file(FOLDER "fifo", "through", &f) == 0 ? 6 : 1);
}

static void direct_targets(void) {
    test("Devices and FIFOs are written directly and stay what they are");
    clean();
    fail f = {{0}};
    CHECK(write_file("/dev/null", "gone", &f) == 0, "%s", f.text);
    struct stat about;
    CHECK(stat("/dev/null", &about) == 0 && S_ISCHR(about.st_mode), "/dev/null is gone");
    CHECK(mkfifo(FOLDER "fifo", 0666) == 0, "no FIFO");
    const int fd = open(FOLDER "fifo", O_RDWR);
    const int status = in_child(write_to_fifo);
    char bytes[16] = {0};
    CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 6, "status %x", status);
    CHECK(read(fd, bytes, sizeof bytes) == 7 && strcmp(bytes, "through") == 0, "%s", bytes);
    close(fd);
    CHECK(stat(FOLDER "fifo", &about) == 0 && S_ISFIFO(about.st_mode), "the FIFO is gone");
    CHECK(entries() == 1, "%d entries", entries());
}

static int master;
static int own_fd; /* the stream whose terminal it is; -1: none */

static void write_to_terminal(void) {
    fail f = {{0}}, g = {{0}};
    const char *name = ptsname(master);
    const int slave = name ? open(name, O_RDWR | O_NOCTTY) : -1;
    if (slave < 0 || (own_fd >= 0 && dup2(slave, own_fd) < 0)) {
        _exit(1);
    }
    output *text = output_open_text(name, &g);
    output_abandon(text);
    const int result = write_file(name, "bytes", &f);
    _exit(!text ? 2 : result == 0 ? 4 : strstr(f.text, "is your terminal, ") != NULL ? 5 : 3);
}

static void terminals(void) {
    test("A terminal is written by its name, but for bytes on that of a standard stream");
    master = posix_openpt(O_RDWR | O_NOCTTY);
    CHECK(master >= 0 && grantpt(master) == 0 && unlockpt(master) == 0, "no pseudo terminal");
    for (own_fd = -1; own_fd <= STDERR_FILENO; own_fd++) {
        const int status = in_child(write_to_terminal);
        CHECK(WIFEXITED(status) && WEXITSTATUS(status) == (own_fd < 0 ? 4 : 5),
              "stream %d: status %x", own_fd, status);
    }
    close(master);
}

static int standard_fd;

static void write_standard(void) {
    fail f = {{0}};
    if (standard_fd < 0) {
        close(STDOUT_FILENO);
    } else {
        dup2(standard_fd, STDOUT_FILENO);
    }
    const int result = write_file("-", "hello", &f);
    const char *end = standard_fd < 0 ? "write: Bad file descriptor; the stream is closed: "
                                        "redirect it to a file"
                                      : "write: No space left on device; free some space or "
                                        "write to another disk";
    char expected[300];
    snprintf(expected, sizeof expected, "standard output: cannot %s", end);
    _exit(result == 0 ? 4 : strcmp(f.text, expected) == 0 ? 5 : 6);
}

static void standard_output(void) {
    test("Standard output is written and its failures are named");
    clean();
    standard_fd = open(TARGET, O_WRONLY | O_CREAT, 0666);
    int status = in_child(write_standard);
    CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 4, "status %x", status);
    CHECK(holds(TARGET, "hello"), "not written");
    close(standard_fd);
    standard_fd = open("/dev/full", O_WRONLY);
    status = in_child(write_standard);
    CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 5, "status %x", status);
    close(standard_fd);
    standard_fd = -1;
    status = in_child(write_standard);
    CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 5, "status %x", status);
}

static void first_failure(void) {
    test("The first failure stays, and hostile names become one line");
    fail f = {{0}};
    CHECK(fail_set(&f, "a\nb\x1b[31m\x7f", "bad %s", "\r\n\t") == -1, "no failure");
    CHECK(strcmp(f.text, "a?b?[31m?: bad ???") == 0, "%s", f.text);
    CHECK(fail_set(&f, "other", "later") == -1, "no failure");
    CHECK(strcmp(f.text, "a?b?[31m?: bad ???") == 0, "%s", f.text);
    char name[5000];
    memset(name, 'n', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    fail g = {{0}};
    fail_set(&g, name, "%s; remedy", "what");
    CHECK(strlen(g.text) < sizeof g.text && strstr(g.text, "n: what; remedy"), "%s", g.text);
    fail h = {{0}};
    fail_set(&h, NULL, "%s", name);
    CHECK(strlen(h.text) == sizeof h.text - 1, "%zu", strlen(h.text));
}

int main(void) {
    signal(SIGINT, SIG_DFL); /* a shell's background ignores these two */
    signal(SIGQUIT, SIG_DFL);
    appears_whole();
    writes_any_length();
    abandons();
    keeps_modes();
    removed_at_end();
    respects_nohup();
    child_removes_nothing();
    refuses_names();
    refuses_rights();
    full_disk();
    size_limit();
    direct_targets();
    terminals();
    standard_output();
    first_failure();
    clean();
    return test_done();
}
