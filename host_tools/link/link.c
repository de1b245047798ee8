/* link - see link.h
 *
 * SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* posix_openpt */
#include "host_tools/link/link.h"

#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <termios.h>
#include <unistd.h>

#include "host_tools/base/clock.h"

static void clear(stream_link *l) {
    memset(l, 0, sizeof *l);
    l->listener = l->peer = -1;
    signal(SIGPIPE, SIG_IGN); /* a peer that has gone shows as EPIPE */
}

static void set_nonblocking(int file) {
    fcntl(file, F_SETFL, fcntl(file, F_GETFL) | O_NONBLOCK);
    fcntl(file, F_SETFD, FD_CLOEXEC);
}

static void restart_stream(stream_link *l) {
    memset(&l->reader, 0, sizeof l->reader);
    l->out_used = l->in_used = l->in_read = 0;
}

/* ---- opening ------------------------------------------------------------------------ */

int link_open_pty(stream_link *l, fail *f) {
    struct termios raw;
    clear(l);
    l->peer = posix_openpt(O_RDWR | O_NOCTTY);
    const char *name =
        l->peer < 0 || grantpt(l->peer) || unlockpt(l->peer) ? NULL : ptsname(l->peer);
    if (name == NULL || tcgetattr(l->peer, &raw) != 0) {
        fail_set(f, "pseudo terminal", "%s; use --socket instead", strerror(errno));
        link_close(l);
        return -1;
    }
    raw.c_iflag = raw.c_oflag = raw.c_lflag = 0; /* bytes as they are */
    raw.c_cflag = CS8 | CREAD | CLOCAL;
    tcsetattr(l->peer, TCSANOW, &raw);
    set_nonblocking(l->peer);
    snprintf(l->name, sizeof l->name, "%s", name);
    l->is_pty = 1;
    return 0;
}

static const char *remedy(int error) {
    switch (error) {
    case ENOENT:
    case ENOTDIR:
        return "create the directory first, or correct the path";
    case EADDRINUSE:
        return "remove it if nobody serves there";
    default:
        return "choose another path";
    }
}

/* A file of this name may be all that somebody has: nobody is told to remove it. */
static int is_other_file(const char *path) {
    struct stat about;
    return lstat(path, &about) == 0 && !S_ISSOCK(about.st_mode);
}

static int fail_listen(stream_link *l, int family, int error, fail *f) {
    if (family == AF_INET) {
        fail_set(f, l->name, "%s; choose another port", strerror(error));
    } else if (error == EADDRINUSE && is_other_file(l->name)) {
        fail_set(f, l->name, "is a file, not a socket; choose another path");
    } else {
        fail_set(f, l->name, "%s; %s", strerror(error), remedy(error));
    }
    link_close(l);
    return -1;
}

typedef struct place {
    int socket;
    const struct sockaddr *address;
    socklen_t bytes;
} place;

static int bind_place(void *context) {
    const place *p = context;
    return bind(p->socket, p->address, p->bytes);
}

/* A path appears with the bind, and must not stay when the program ends. */
static int bind_to(stream_link *l, int family, const struct sockaddr *address, socklen_t bytes) {
    place p = {l->listener, address, bytes};
    return family == AF_UNIX ? temporary_make(&l->made, l->name, bind_place, &p) : bind_place(&p);
}

static int listen_at(stream_link *l, int family, const struct sockaddr *address, socklen_t bytes,
                     fail *f) {
    const int on = 1;
    l->listener = socket(family, SOCK_STREAM, 0);
    if (l->listener >= 0 && family == AF_INET) {
        setsockopt(l->listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    }
    if (l->listener < 0 || bind_to(l, family, address, bytes) != 0 || listen(l->listener, 1) != 0) {
        return fail_listen(l, family, errno, f);
    }
    set_nonblocking(l->listener);
    return 0;
}

int link_open_socket(stream_link *l, const char *path, fail *f) {
    struct sockaddr_un at = {.sun_family = AF_UNIX};
    clear(l);
    if (strlen(path) >= sizeof at.sun_path) {
        return fail_set(f, path, "the path is too long for a socket; choose a shorter one");
    }
    memcpy(at.sun_path, path, strlen(path) + 1);
    snprintf(l->name, sizeof l->name, "%s", path);
    return listen_at(l, AF_UNIX, (const struct sockaddr *)&at, sizeof at, f);
}

int link_open_port(stream_link *l, unsigned port, fail *f) {
    struct sockaddr_in at = {.sin_family = AF_INET, .sin_port = htons((uint16_t)port)};
    clear(l);
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    snprintf(l->name, sizeof l->name, "127.0.0.1:%u", port);
    return listen_at(l, AF_INET, (const struct sockaddr *)&at, sizeof at, f);
}

void link_of_file(stream_link *l, int file) {
    clear(l);
    l->peer = file;
    set_nonblocking(file);
}

void link_close(stream_link *l) {
    if (l->peer >= 0) {
        close(l->peer);
    }
    if (l->listener >= 0) {
        close(l->listener);
    }
    temporary_remove(&l->made);
    l->peer = l->listener = -1;
}

/* ---- moving --------------------------------------------------------------------------- */

static void hang_up(stream_link *l) {
    if (!l->is_pty) {
        close(l->peer);
        l->peer = -1;
    }
    restart_stream(l);
}

static int flush_out(stream_link *l) {
    while (l->out_used > 0) {
        const ssize_t n = write(l->peer, l->out, l->out_used);
        if (n < 0) {
            return errno == EAGAIN || errno == EINTR ? 0 : -1;
        }
        l->out_used -= (size_t)n;
        memmove(l->out, l->out + n, l->out_used);
    }
    return 0;
}

static int stream_send(void *context, const uint8_t *report, size_t count) {
    stream_link *l = context;
    if (l->peer < 0) {
        return -1;
    }
    if (flush_out(l) != 0) {
        hang_up(l);
        return -1;
    }
    if (l->out_used + WIRE_BYTES_MOST > sizeof l->out || l->out_used > 0) {
        return 0;
    }
    l->out_used = wire_bytes_put(l->out, report, count);
    return flush_out(l) == 0 ? 1 : (hang_up(l), -1);
}

static int wait_readable(int file, int ms) {
    struct pollfd p = {.fd = file, .events = POLLIN};
    return poll(&p, 1, ms) > 0;
}

static int accept_peer(stream_link *l, int ms) {
    if (l->listener >= 0 && wait_readable(l->listener, ms)) {
        l->peer = accept(l->listener, NULL, NULL);
        if (l->peer >= 0) {
            set_nonblocking(l->peer);
            restart_stream(l);
        }
    }
    return -1; /* the session begins when the next call finds a peer */
}

static int stream_receive(void *context, uint8_t *report, int ms) {
    stream_link *l = context;
    if (l->peer < 0) {
        return accept_peer(l, ms);
    }
    if (l->in_read == l->in_used) {
        wait_readable(l->peer, ms);
        const ssize_t n = read(l->peer, l->in, sizeof l->in);
        if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR)) {
            if (!l->is_pty) {
                hang_up(l);
                return -1;
            }
            clock_sleep(0.001); /* no program has it open: poll returns at once */
        }
        l->in_read = 0;
        l->in_used = n > 0 ? (size_t)n : 0;
    }
    while (l->in_read < l->in_used) {
        const size_t count = wire_bytes_read(&l->reader, l->in[l->in_read++]);
        if (count > 0) {
            memcpy(report, l->reader.report, count);
            return (int)count;
        }
    }
    return 0;
}

transport link_transport(stream_link *l) {
    return (transport){l, stream_send, stream_receive};
}
