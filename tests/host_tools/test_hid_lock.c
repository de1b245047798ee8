/* test_hid_lock - two programs on one display
 *
 * The node is a file of the test's own, which is locked as a device's is.
 *
 * SPDX-License-Identifier: MIT */
#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host_tools/hid/device/lock.h"
#include "host_tools/hid/device/port.h"
#include "tests/reference/fake_hidapi.h"
#include "tests/test.h"

static const char path[] = TEST_FOLDER "test_hid_lock.node";

static const fake_device device = {.path = path, .vendor = 0x1B1C, .product = 0x1B8E};

static port *open_it(fail *f) {
    port_info *list;
    *f = (fail){""};
    fake_bus_reset();
    fake_plug(0, &device);
    CHECK(port_list(&list) == 1, "it is on the bus");
    port *p = port_open(list, f);
    free(list);
    return p;
}

/* Another process that holds the display until it is killed. */
static pid_t hold(void) {
    int ready[2];
    char byte = 0;
    if (pipe(ready) != 0) {
        return -1;
    }
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        fail f;
        byte = open_it(&f) != NULL;
        const int told = write(ready[1], &byte, 1) == 1;
        while (told) {
            pause();
        }
        _exit(1);
    }
    CHECK(read(ready[0], &byte, 1) == 1 && byte == 1, "the other process has it");
    close(ready[0]);
    close(ready[1]);
    return child;
}

static void two(void) {
    fail f;
    char process[40];
    test("a display that another process shows on: a sentence that names it");
    const pid_t child = hold();
    CHECK(open_it(&f) == NULL, "opened twice");
    snprintf(process, sizeof process, "process %ld ", (long)child);
    const int is_named = access("/proc/locks", R_OK) == 0;
    CHECK(strstr(f.text, is_named ? process : "another program"), "%s", f.text);
    CHECK(strstr(f.text, "stop that one, or choose another display with --device"), "%s", f.text);
    CHECK(fake_bus.opens == 0 && fake_bus.open == 0, "the device was not touched");

    test("... and once that is killed, it opens: no lock is stale");
    kill(child, SIGKILL);
    waitpid(child, NULL, 0);
    port *p = open_it(&f);
    CHECK(p != NULL, "%s", f.text);
    port_close(p);
}

static void once(void) {
    fail f;
    long holder;
    test("one that was closed, or that did not open, is not held");
    port *p = open_it(&f);
    CHECK(p != NULL && lock_take(path, &holder) == LOCK_HELD, "%s", f.text);
    CHECK(holder == 0 || holder == getpid(), "%ld", holder);
    port_close(p);
    int lock = lock_take(path, &holder);
    CHECK(lock >= 0, "%d", lock);
    lock_release(lock);
    fake_bus.denied = 1;
    port_info info = {.path = ""};
    snprintf(info.path, sizeof info.path, "%s", path);
    CHECK(port_open(&info, &f) == NULL && strstr(f.text, "cannot open"), "%s", f.text);
    lock = lock_take(path, &holder);
    CHECK(lock >= 0, "%d", lock);
    lock_release(lock);

    test("a path of libusb, or a node that may not be opened, is nothing to lock");
    const char *const name = "1-2:1.0";
    FILE *file = fopen(name, "wx");
    CHECK(file != NULL && fclose(file) == 0, "a file of that name");
    CHECK(lock_take(name, &holder) == LOCK_NONE, "libusb");
    remove(name);
    CHECK(lock_take(TEST_FOLDER, &holder) == LOCK_NONE, "a folder");
    lock_release(LOCK_NONE);
}

int main(void) {
    mkdir(TEST_FOLDER, 0777);
    FILE *node = fopen(path, "wb");
    if (node == NULL || fclose(node) != 0) {
        return 1;
    }
    two();
    once();
    remove(path);
    return test_done();
}
