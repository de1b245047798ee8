/* cache - see cache.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/cache.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "board/hash.h"
#include "engine/planelet.h"
#include "engine/planelet_crc32.h"
#include "host_tools/base/heap.h"

#define HEAD "planelet tables cache 1\n"

enum { LINE = 640, MOST_BYTES = 16 << 20 };

static int keep(cache *c, uint64_t key, const figures *what) {
    if (c->entries == c->room) {
        const unsigned room = 2 * c->room + 256;
        cache_entry *grown = heap_resize(c->entry, (uint64_t)room * sizeof *grown);
        if (grown == NULL) {
            return -1;
        }
        c->entry = grown;
        c->room = room;
    }
    c->entry[c->entries++] = (cache_entry){key, *what};
    return 0;
}

int cache_find(const cache *c, uint64_t key, figures *what) {
    for (unsigned i = c->entries; i > 0; i--) {
        if (c->entry[i - 1].key == key) {
            *what = c->entry[i - 1].what;
            return 1;
        }
    }
    return 0;
}

/* "KEY FIGURE ... FIGURE SUM\n"; its length. */
static size_t line_of(char *to, uint64_t key, const figures *what) {
    size_t at = (size_t)snprintf(to, LINE, "%016" PRIx64, key);
    for (unsigned i = 0; i < FIGURES; i++) {
        const double v = what->of[i];
        at += (size_t)(isnan(v) ? snprintf(to + at, LINE - at, " -")
                                : snprintf(to + at, LINE - at, " %.17g", v));
    }
    const uint32_t sum = plt_crc32(0, (const uint8_t *)to, at);
    return at + (size_t)snprintf(to + at, LINE - at, " %08" PRIx32 "\n", sum);
}

/* Figures are counts, bytes and seconds: from 0 up, and finite. */
static int read_figure(const char **at, double *value) {
    char *end;
    if ((*at)[0] == ' ' && (*at)[1] == '-' && (*at)[2] == ' ') {
        *value = (double)NAN;
        *at += 2;
        return 0;
    }
    if ((*at)[0] != ' ' || (*at)[1] < '0' || (*at)[1] > '9') {
        return -1;
    }
    *value = strtod(*at + 1, &end);
    *at = end;
    return isfinite(*value) && *value >= 0.0 && *end == ' ' ? 0 : -1;
}

/* A line without its end; what is read has to be written as just that line again. */
static int read_line(const char *line, uint64_t *key, figures *what) {
    char again[LINE];
    char *end;
    const char *at;
    *key = strtoull(line, &end, 16);
    at = end;
    for (unsigned i = 0; i < FIGURES; i++) {
        if (read_figure(&at, &what->of[i]) != 0) {
            return -1;
        }
    }
    const size_t length = line_of(again, *key, what);
    return strlen(line) + 1 == length && memcmp(line, again, length - 1) == 0 ? 0 : -1;
}

static int read_lines(cache *c, char *text, fail *f) {
    for (char *line = text, *end; *line != '\0'; line = end + 1) {
        uint64_t key;
        figures what;
        end = strchr(line, '\n');
        if (end == NULL) {
            c->refused++;
            return 0;
        }
        *end = '\0';
        if (read_line(line, &key, &what) != 0) {
            c->refused++;
        } else if (keep(c, key, &what) != 0) {
            return fail_set(f, c->path, "out of memory; close other programs");
        }
    }
    return 0;
}

/* The file as a text; zeros in it become blanks, which no line has two of. NULL: `f` says why. */
static char *read_text(const cache *c, size_t size, fail *f) {
    char *text = heap_get((uint64_t)size + 1);
    size_t got = 0;
    if (text == NULL) {
        fail_set(f, c->path, "out of memory; close other programs");
        return NULL;
    }
    ssize_t n = 1;
    while (got < size && n != 0) {
        n = read(c->file, text + got, size - got);
        if (n < 0 && errno != EINTR) {
            fail_set(f, c->path, "cannot read: %s; move it away, or choose another folder for -o",
                     strerror(errno));
            heap_drop(text);
            return NULL;
        }
        got += n > 0 ? (size_t)n : 0;
    }
    for (size_t i = 0; i < got; i++) {
        text[i] = text[i] == '\0' ? ' ' : text[i];
    }
    text[got] = '\0';
    return text;
}

static int refuse(const cache *c, const char *why, fail *f) {
    return fail_set(f, c->path, "%s; move it away, or choose another folder for -o", why);
}

/* What was written of a line that did not fit is taken away again, so that the file has whole
 * lines; unless others have written behind it. */
static void take_back(const cache *c, off_t end, size_t done) {
    struct stat about;
    if (done > 0 && fstat(c->file, &about) == 0 && about.st_size == end + (off_t)done &&
        ftruncate(c->file, end) != 0) {
        return; /* it will be taken for damaged */
    }
}

static int write_all(const cache *c, const char *bytes, size_t count, fail *f) {
    struct stat about;
    const off_t end = fstat(c->file, &about) == 0 ? about.st_size : 0;
    for (size_t done = 0; done < count;) {
        const ssize_t n = write(c->file, bytes + done, count - done);
        if (n < 0 && errno != EINTR) {
            const int why = errno;
            take_back(c, end, done);
            return fail_set(f, c->path, "cannot write: %s; free some space, or choose another -o",
                            strerror(why));
        }
        done += n > 0 ? (size_t)n : 0;
    }
    return 0;
}

static int load(cache *c, fail *f) {
    struct stat about;
    if (fstat(c->file, &about) != 0 || !S_ISREG(about.st_mode)) {
        return refuse(c, "is no regular file", f);
    }
    if (about.st_size == 0) {
        return write_all(c, HEAD, strlen(HEAD), f);
    }
    if (about.st_size > MOST_BYTES) {
        return refuse(c, "is larger than any cache of tables", f);
    }
    char *text = read_text(c, (size_t)about.st_size, f);
    int status = text != NULL ? 0 : -1;
    const int is_whole = status == 0 && text[0] != '\0' && text[strlen(text) - 1] == '\n';
    if (status == 0 && strncmp(text, HEAD, strlen(HEAD)) != 0) {
        status = refuse(c, "is not a cache of planelet tables", f);
    }
    if (status == 0) {
        status = read_lines(c, text + strlen(HEAD), f);
        if (status == 0 && !is_whole) {
            status = write_all(c, "\n", 1, f); /* what follows is not to continue that line */
        }
    }
    heap_drop(text);
    return status;
}

/* SIGXFSZ is ignored, so that a write past the limit of a file's size fails, too. */
int cache_open(cache *c, const char *folder, fail *f) {
    signal(SIGXFSZ, SIG_IGN);
    memset(c, 0, sizeof *c);
    c->file = -1;
    const int n = snprintf(c->path, sizeof c->path, "%s/" CACHE_NAME, folder);
    if (n < 0 || (size_t)n >= sizeof c->path) {
        return fail_set(f, folder, "the name is too long; choose a shorter one");
    }
    const int is_new = access(c->path, F_OK) != 0;
    c->file = open(c->path, O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
    if (c->file < 0) {
        return fail_set(f, c->path, "cannot open: %s; choose a folder you own for -o",
                        strerror(errno));
    }
    if (load(c, f) != 0) {
        cache_close(c);
        if (is_new) {
            unlink(c->path);
        }
        return -1;
    }
    return 0;
}

void cache_close(cache *c) {
    if (c->file >= 0) {
        close(c->file);
    }
    heap_drop(c->entry);
    c->entry = NULL;
    c->entries = c->room = 0;
    c->file = -1;
}

int cache_add(cache *c, uint64_t key, const figures *what, fail *f) {
    char line[LINE];
    const size_t length = line_of(line, key, what);
    if (keep(c, key, what) != 0) {
        return fail_set(f, c->path, "out of memory; close other programs");
    }
    return write_all(c, line, length, f);
}

uint64_t cache_program(void) {
    static const uint8_t version[] = {PLT_VERSION_MAJOR, PLT_VERSION_MINOR};
    uint64_t hash = hash_bytes(version, sizeof version);
    uint8_t bytes[65536];
    FILE *self = fopen("/proc/self/exe", "rb");
    size_t got = 0;
    while (self != NULL && (got = fread(bytes, 1, sizeof bytes, self)) > 0) {
        hash = hash_update(hash, bytes, got);
    }
    if (self != NULL) {
        fclose(self);
    }
    return hash;
}
