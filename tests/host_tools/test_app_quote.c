/* test_app_quote - file names as words for the shell
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "host_tools/app/quote.h"
#include "tests/test.h"

static void check(const char *name, const char *expected) {
    char to[QUOTE_ROOM];
    const char *word = quote_word(to, sizeof to, name);
    CHECK(word != NULL && strcmp(word, expected) == 0, "%s, not %s", word ? word : "none",
          expected);
}

/* What a shell makes of the word, as octal numbers, is the name. */
static void check_shell(const char *name) {
    char word[QUOTE_ROOM], line[2 * QUOTE_ROOM], read[QUOTE_ROOM] = "";
    CHECK(quote_word(word, sizeof word, name) != NULL, "%s does not fit", name);
    snprintf(line, sizeof line, "printf %%s %s", word);
    FILE *shell = popen(line, "r");
    const size_t bytes = shell != NULL ? fread(read, 1, sizeof read - 1, shell) : 0;
    CHECK(shell != NULL && pclose(shell) == 0, "no shell");
    CHECK(bytes == strlen(name) && memcmp(read, name, bytes) == 0, "%s came back as %s", word,
          read);
}

static void every_byte(void) {
    for (int c = 0x20; c < 0x100; c++) {
        const char name[] = {'a', (char)c, (char)c, 'b', '\0'};
        if (c != 0x7f) {
            check_shell(name);
        }
    }
}

static void check_value(const char *value, const char *expected) {
    char to[QUOTE_ROOM];
    const char *word = quote_value(to, sizeof to, value);
    CHECK(word != NULL && strcmp(word, expected) == 0, "%s, not %s", word ? word : "none",
          expected);
}

static void check_room_for(const char *name, size_t spare) {
    char to[QUOTE_ROOM];
    const size_t room = quote_room_for(strlen(name));
    CHECK(quote_word(to, room, name) != NULL, "%s does not fit", name);
    CHECK(room - strlen(to) - 1 == spare, "%s leaves %zu bytes", name, room - strlen(to) - 1);
}

static void check_room(void) {
    char name[QUOTE_ROOM + 8], to[QUOTE_ROOM];
    memset(name, 'x', sizeof name);
    for (size_t length = QUOTE_ROOM - 8; length < sizeof name; length++) {
        name[length] = '\0';
        memset(to, '#', sizeof to);
        const char *word = quote_word(to, sizeof to, name);
        CHECK((word != NULL) == (length < sizeof to), "%zu bytes", length);
        CHECK(word == NULL || strcmp(word, name) == 0, "%zu bytes: %s", length, to);
        name[0] = '-';
        CHECK((quote_word(to, sizeof to, name) != NULL) == (length + 2 < sizeof to),
              "%zu bytes with a dash", length);
        name[0] = ' ';
        CHECK((quote_word(to, sizeof to, name) != NULL) == (length + 2 < sizeof to),
              "%zu bytes with a blank", length);
        name[0] = '\x01';
        CHECK((quote_word(to, sizeof to, name) != NULL) == (length + 6 < sizeof to),
              "%zu bytes with a control", length);
        name[0] = name[length] = 'x';
    }
}

int main(void) {
    test("plain names stay as they are");
    check("bunny.ply", "bunny.ply");
    check("/a/b-c_d/e.1,2:3+4@5%6", "/a/b-c_d/e.1,2:3+4@5%6");
    check("../-x", "../-x");
    test("others go into quotes, and no name is a flag or nothing");
    check("", "''");
    check("a b", "'a b'");
    check("it's", "'it'\\''s'");
    check("~root", "'~root'");
    check("-x", "./-x");
    check("--help me", "'./--help me'");
    test("control characters become escapes, which the line shows");
    check("a\nb", "$'a\\012b'");
    check("\x1b[31m'\\\x7f", "$'\\033[31m\\'\\\\\\177'");
    check("-\t", "$'./-\\011'");
    test("a value may begin with a dash");
    check_value("-", "-");
    check_value("-1,2,-3", "-1,2,-3");
    check_value("- 1", "'- 1'");
    check_value("-\t", "$'-\\011'");
    test("the room for any text is enough, and not much too large");
    check_room_for("''", 3);
    check_room_for("\x01\x02", 2);
    check_room_for("-\x01\x02", 3);
    test("a shell reads every other byte back");
    every_byte();
    test("a word that does not fit is none");
    check_room();
    return test_done();
}
