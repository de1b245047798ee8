/* test_board_host - the host's arena and scene files
 *
 * SPDX-License-Identifier: MIT */
#include <fcntl.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "board/host/host.h"
#include "tests/test.h"

static char folder[] = "build/test-board-XXXXXX"; /* tests run from the top folder */
static char path[100];

static const char *in_folder(const char *name) {
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

/* A file of `bytes`, its first 5000 counted up; the rest is a hole. */
static const char *make_file(const char *name, off_t bytes) {
    unsigned char head[5000];
    const int file = open(in_folder(name), O_CREAT | O_WRONLY | O_TRUNC, 0600);
    for (unsigned i = 0; i < sizeof head; i++) {
        head[i] = (unsigned char)(i * 7);
    }
    const size_t count = bytes < (off_t)sizeof head ? (size_t)bytes : sizeof head;
    if (file < 0 || write(file, head, count) != (ssize_t)count || ftruncate(file, bytes) < 0) {
        perror(path);
    }
    close(file);
    return path;
}

static void check_refused(const char *name, const char *word) {
    host_scene scene;
    char sentence[160];
    snprintf(sentence, sizeof sentence, "refused, mapped or fetched, with \"%s\"", word);
    test(sentence);
    CHECK(host_scene_map(&scene, name) < 0, "mapped");
    CHECK(strstr(scene.why, word), "why: %s", scene.why);
    host_scene_close(&scene);
    CHECK(host_scene_fetch(&scene, name) < 0, "fetched");
    CHECK(strstr(scene.why, word), "why: %s", scene.why);
    host_scene_close(&scene);
}

static void test_refusals(void) {
    check_refused(folder, "directory");
    check_refused(make_file("empty", 0), "empty");
    check_refused(in_folder("missing"), "No such file");
    check_refused(make_file("large", (off_t)1 << 32), "4 GiB");
    check_refused("/dev/null", "regular file");
    mkfifo(in_folder("pipe"), 0600);
    check_refused(in_folder("pipe"), "regular file");
    if (geteuid() == 0) {
        printf("    root may read everything: permissions are not tested\n");
        return;
    }
    chmod(make_file("secret", 10), 0);
    check_refused(in_folder("secret"), "ermission");
}

static void test_map(void) {
    host_scene scene;
    test("a mapped scene is the file's bytes, aligned");
    CHECK(host_scene_map(&scene, make_file("scene", 4999)) == 0, "%s", scene.why);
    CHECK(scene.source.bytes == 4999 && scene.source.mapped, "%u bytes", scene.source.bytes);
    CHECK((uintptr_t)scene.source.mapped % PLT_ALIGN == 0, "alignment");
    const unsigned char *bytes = scene.source.mapped;
    for (unsigned i = 0; bytes && i < 4999; i++) {
        CHECK(bytes[i] == (unsigned char)(i * 7), "byte %u", i);
    }
    host_scene_close(&scene);
    test("a file of 4 GiB less one byte can be mapped");
    CHECK(host_scene_map(&scene, make_file("large", ((off_t)1 << 32) - 1)) == 0, "%s", scene.why);
    CHECK(scene.source.bytes == UINT32_MAX, "%u", scene.source.bytes);
    host_scene_close(&scene);
    unlink(path);
}

static void test_fetch(void) {
    host_scene scene;
    unsigned char to[2][100];
    memset(to, 0, sizeof to);
    test("a fetched scene moves its bytes at the wait for their tag, and counts them");
    CHECK(host_scene_fetch(&scene, make_file("scene", 4999)) == 0, "%s", scene.why);
    plt_source *s = &scene.source;
    CHECK(!s->mapped && s->bytes == 4999, "source");
    CHECK(s->start(s->context, 3, 10, to[0], 100) == 0, "start");
    CHECK(s->start(s->context, 31, 4899, to[1], 100) == 0, "start");
    CHECK(s->wait(s->context, 1u << 31) == 0, "wait 31");
    CHECK(to[0][1] == 0, "tag 3 was not waited for");
    CHECK(s->wait(s->context, 1u << 3) == 0, "wait 3");
    for (unsigned i = 0; i < 100; i++) {
        CHECK(to[0][i] == (unsigned char)((10 + i) * 7), "byte %u", i);
        CHECK(to[1][i] == (unsigned char)((4899 + i) * 7), "byte %u", i);
    }
    CHECK(scene.transfers == 2 && scene.bytes_moved == 200, "counts");
    test("a fetch beyond the end of the file fails, and a full table refuses");
    CHECK(s->start(s->context, 0, 4950, to[0], 100) == 0, "start");
    CHECK(s->wait(s->context, 1) < 0, "wait");
    for (int i = 0; i < HOST_TRANSFERS; i++) {
        CHECK(s->start(s->context, 0, 0, to[0], 1) == 0, "start %d", i);
    }
    CHECK(s->start(s->context, 0, 0, to[0], 1) < 0, "one too many");
    CHECK(s->wait(s->context, 1) == 0, "all of them");
    host_scene_close(&scene);
    host_scene_close(&scene);
}

static void test_hold(void) {
    static _Alignas(PLT_ALIGN) unsigned char bytes[5000];
    host_scene scene;
    unsigned char to[100];
    for (unsigned i = 0; i < sizeof bytes; i++) {
        bytes[i] = (unsigned char)(i * 7);
    }
    test("a scene in memory is there as a mapped file, or fetched as a file");
    host_scene_hold(&scene, bytes, 4999, 0);
    CHECK(scene.source.mapped == bytes && scene.source.bytes == 4999, "mapped");
    host_scene_close(&scene);
    host_scene_hold(&scene, bytes, 4999, 1);
    plt_source *s = &scene.source;
    CHECK(!s->mapped && s->bytes == 4999, "source");
    memset(to, 0, sizeof to);
    CHECK(s->start(s->context, 3, 4899, to, 100) == 0 && to[1] == 0, "start");
    CHECK(s->wait(s->context, 1u << 3) == 0, "wait");
    CHECK(memcmp(to, bytes + 4899, 100) == 0, "other bytes");
    CHECK(scene.transfers == 1 && scene.bytes_moved == 100, "counts");
    CHECK(s->start(s->context, 0, 4900, to, 100) == 0 && s->wait(s->context, 1) < 0, "the end");
    CHECK(s->start(s->context, 0, UINT32_MAX, to, 100) == 0 && s->wait(s->context, 1) < 0, "far");
    host_scene_close(&scene);
    host_scene_close(&scene);
    CHECK(bytes[1] == 7, "not its own");
}

static rlim_t address_space(rlim_t bytes) {
    struct rlimit limit;
    getrlimit(RLIMIT_AS, &limit);
    const rlim_t before = limit.rlim_cur;
    limit.rlim_cur = bytes;
    CHECK(setrlimit(RLIMIT_AS, &limit) == 0, "no limit");
    return before;
}

static void test_arena(void) {
    test("the arena is aligned, zero, no larger than asked for, and the same until it grows");
    CHECK(host_arena_bytes() >= (size_t)1 << 30, "%zu bytes", host_arena_bytes());
    CHECK(!host_arena(host_arena_bytes() + 1), "too much");
    unsigned char *arena = host_arena(100000);
    CHECK(arena && (uintptr_t)arena % 4096 == 0, "alignment");
    for (unsigned i = 0; arena && i < 100000; i++) {
        CHECK(arena[i] == 0, "byte %u", i);
        arena[i] = 1;
    }
    CHECK(host_arena(0) == arena && host_arena(1) == arena && host_arena(100000) == arena, "moved");
#if !defined(__SANITIZE_ADDRESS__)
    test("what the system does not give is no arena, and less can still be had");
    const rlim_t before = address_space((rlim_t)256 << 20);
    CHECK(!host_arena(host_arena_bytes()), "given");
    CHECK(host_arena(1 << 20), "not given");
    address_space(before);
#else
    (void)address_space; /* the sanitizer has taken more than any limit */
#endif
    test("all of it");
    arena = host_arena(host_arena_bytes());
    CHECK(arena && arena[0] == 0 && arena[host_arena_bytes() - 1] == 0, "not zero");
    CHECK(host_arena(host_arena_bytes()) == arena && host_arena(5) == arena, "moved");
    test("several arenas lie side by side, each aligned and as large as asked for");
    CHECK(!host_arenas(2, host_arena_bytes() + 1), "too much for each");
    CHECK(!host_arenas(UINT32_MAX, SIZE_MAX / UINT32_MAX / 2 < host_arena_bytes()
                                       ? SIZE_MAX / UINT32_MAX / 2
                                       : host_arena_bytes()),
          "too much for all");
    for (size_t bytes = 1; bytes < 1000000; bytes = 9 * bytes + 5) {
        arena = host_arenas(3, bytes);
        const size_t stride = host_arena_stride(bytes);
        CHECK(arena && stride >= bytes && stride % 4096 == 0, "%zu: %zu", bytes, stride);
        arena[2 * stride + bytes - 1] = 1;
    }
}

static void test_share(void) {
    host_scene scene, mine;
    unsigned char to[2] = {0, 0};
    test("a shared scene has transfers of its own, over the same bytes");
    CHECK(host_scene_fetch(&scene, make_file("scene", 4999)) == 0, "%s", scene.why);
    host_scene_share(&mine, &scene);
    const plt_source *s = &scene.source, *m = &mine.source;
    CHECK(m->bytes == 4999 && !m->mapped, "source");
    CHECK(s->start(s->context, 3, 10, &to[0], 1) == 0, "start");
    CHECK(m->start(m->context, 3, 20, &to[1], 1) == 0, "start");
    CHECK(m->wait(m->context, 1u << 3) == 0, "wait");
    CHECK(to[0] == 0 && to[1] == 20 * 7, "%u %u", to[0], to[1]);
    CHECK(s->wait(s->context, 1u << 3) == 0 && to[0] == 10 * 7, "the other's");
    CHECK(scene.transfers == 1 && mine.transfers == 1, "counts");
    const int file = mine.file;
    host_scene_close(&mine);
    CHECK(file != scene.file && fcntl(file, F_GETFD) < 0, "its file is left open");
    CHECK(s->start(s->context, 3, 30, &to[0], 1) == 0 && s->wait(s->context, 1u << 3) == 0 &&
              to[0] == 30 * 7,
          "the other goes on");
    host_scene_close(&scene);
    CHECK(host_scene_map(&scene, make_file("scene", 4999)) == 0, "%s", scene.why);
    host_scene_share(&mine, &scene);
    CHECK(mine.source.mapped == scene.source.mapped && mine.source.bytes == 4999, "mapped");
    host_scene_close(&mine);
    CHECK(((const unsigned char *)scene.source.mapped)[100] == (unsigned char)(100 * 7),
          "the other's bytes are still there");
    host_scene_close(&scene);
    host_scene_hold(&scene, "planelet", 8, 1);
    host_scene_share(&mine, &scene);
    CHECK(m->start(m->context, 0, 2, to, 2) == 0 && m->wait(m->context, 1) == 0, "in memory");
    CHECK(to[0] == 'a' && to[1] == 'n', "%c%c", to[0], to[1]);
    host_scene_close(&mine);
    host_scene_close(&scene);
}

int main(void) {
    if (!mkdtemp(folder)) {
        perror(folder);
        return 1;
    }
    test_refusals();
    test_map();
    test_fetch();
    test_hold();
    test_share();
    test_arena();
    static const char *const names[] = {"empty", "large", "pipe", "secret", "scene"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        unlink(in_folder(names[i]));
    }
    rmdir(folder);
    return test_done();
}
