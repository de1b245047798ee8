/* fail - host_tools/base/fail.h for a page, which has no printf: %s, %d, %u and %c
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/fail.h"

#include <stdarg.h>
#include <stddef.h>

typedef struct sentence {
    char *text;
    size_t length, room;
} sentence;

static void put(sentence *s, char c) {
    if (s->length + 1 < s->room) {
        s->text[s->length++] = (unsigned char)c < 0x20 || c == 0x7f ? '?' : c;
        s->text[s->length] = '\0';
    }
}

static void put_text(sentence *s, const char *text) {
    for (; *text != '\0'; text++) {
        put(s, *text);
    }
}

static void put_number(sentence *s, unsigned number) {
    char digits[10];
    unsigned count = 0;
    do {
        digits[count++] = (char)('0' + number % 10);
        number /= 10;
    } while (number > 0);
    while (count > 0) {
        put(s, digits[--count]);
    }
}

/* The next argument, as the letter says. */
static void put_argument(sentence *s, char letter, va_list *arguments) {
    if (letter == 's') {
        put_text(s, va_arg(*arguments, const char *));
    } else if (letter == 'u') {
        put_number(s, va_arg(*arguments, unsigned));
    } else if (letter == 'd') {
        const int number = va_arg(*arguments, int);
        if (number < 0) {
            put(s, '-');
        }
        put_number(s, number < 0 ? 0u - (unsigned)number : (unsigned)number);
    } else if (letter == 'c') {
        put(s, (char)va_arg(*arguments, int));
    } else {
        put(s, letter);
    }
}

int fail_set(fail *f, const char *file, const char *format, ...) {
    if (f->text[0] != '\0') {
        return -1;
    }
    sentence s = {f->text, 0, sizeof f->text};
    if (file != NULL) {
        put_text(&s, file);
        put_text(&s, ": ");
    }
    va_list arguments;
    va_start(arguments, format);
    for (; *format != '\0'; format++) {
        if (*format == '%' && format[1] != '\0') {
            put_argument(&s, *++format, &arguments);
        } else {
            put(&s, *format);
        }
    }
    va_end(arguments);
    return -1;
}
