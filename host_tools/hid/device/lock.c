/* lock - see lock.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/lock.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

/* Linux keeps 12 bits of the first and 20 of the second number so. */
static int is_device(uint64_t device, unsigned major, unsigned minor) {
    return (device >> 8 & 0xFFF) == major && ((device & 0xFF) | (device >> 12 & 0xFFF00)) == minor;
}

/* Linux lists locks: number, kind, ADVISORY, WRITE, process, device and inode. */
static long holder_of(int file) {
    struct stat node;
    char line[200];
    FILE *locks = fopen("/proc/locks", "r");
    long holder = 0;
    if (locks == NULL || fstat(file, &node) != 0) {
        node.st_ino = 0;
    }
    while (locks != NULL && holder == 0 && fgets(line, sizeof line, locks) != NULL) {
        long process;
        unsigned major, minor;
        unsigned long long inode;
        if (sscanf(line, "%*d: FLOCK ADVISORY WRITE %ld %x:%x:%llu", &process, &major, &minor,
                   &inode) == 4 &&
            inode == node.st_ino && is_device(node.st_dev, major, minor)) {
            holder = process > 0 ? process : 0;
        }
    }
    if (locks != NULL) {
        fclose(locks);
    }
    return holder;
}

int lock_take(const char *path, long *holder) {
    /* libusb's "1-2:1.0" would be a file of the folder where we are. */
    const int is_file = strchr(path, '/') != NULL;
    const int file = is_file ? open(path, O_RDWR | O_CLOEXEC | O_NONBLOCK | O_NOCTTY) : -1;
    *holder = 0;
    if (file < 0) {
        return LOCK_NONE;
    }
    if (flock(file, LOCK_EX | LOCK_NB) == 0) {
        return file;
    }
    const int is_held = errno == EWOULDBLOCK;
    *holder = is_held ? holder_of(file) : 0;
    close(file);
    return is_held ? LOCK_HELD : LOCK_NONE;
}

void lock_release(int lock) {
    if (lock >= 0) {
        close(lock);
    }
}
