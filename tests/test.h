/* test - properties named as sentences, counted, never stopping the run
 *
 * A test program calls `test("sentence")` before each property, then any
 * number of CHECKs, and returns `test_done()`. A property passes when it
 * had at least one CHECK and none failed.
 *
 * SPDX-License-Identifier: MIT */
#ifndef TEST_H
#define TEST_H
#include <stdio.h>
#include <string.h>

/* Where test programs of this build may write, those of another build being run at the same time
 * (board/host/board.mk). */
#ifndef TEST_FOLDER
#define TEST_FOLDER "build/test-tmp/"
#endif

static struct {
    char sentence[200];
    unsigned long checks, wrong, passed, failed;
} test_state;

static inline void test_close(void) {
    if (!test_state.sentence[0]) {
        return;
    }
    const int good = test_state.checks > 0 && test_state.wrong == 0;
    if (test_state.checks == 0) {
        printf("    nothing was checked\n");
    }
    printf("%s %s (%lu checks)\n", good ? "pass" : "FAIL", test_state.sentence, test_state.checks);
    good ? test_state.passed++ : test_state.failed++;
    test_state.sentence[0] = '\0';
    fflush(stdout);
}

static inline void test(const char *sentence) {
    test_close();
    snprintf(test_state.sentence, sizeof test_state.sentence, "%s", sentence);
    test_state.checks = test_state.wrong = 0;
}

static inline int test_done(void) {
    test_close();
    printf("%lu passed, %lu failed\n", test_state.passed, test_state.failed);
    return test_state.failed != 0;
}

/* Counts a check; on failure says where and why (the first ten times). */
#define CHECK(condition, ...)                                                                      \
    do {                                                                                           \
        test_state.checks++;                                                                       \
        if (!(condition) && test_state.wrong++ < 10) {                                             \
            printf("    %s:%d: %s: ", __FILE__, __LINE__, #condition);                             \
            printf(__VA_ARGS__);                                                                   \
            printf("\n");                                                                          \
        }                                                                                          \
    } while (0)

#endif
