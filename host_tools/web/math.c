/* math - see headers/math.h
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#define OF_MATH(name) __attribute__((import_module("math"), import_name(name)))

OF_MATH("sin") extern double math_sin(double x);
OF_MATH("cos") extern double math_cos(double x);
OF_MATH("tan") extern double math_tan(double x);
OF_MATH("asin") extern double math_asin(double x);
OF_MATH("fmod") extern double math_fmod(double x, double y);

double sin(double x) {
    return math_sin(x);
}

double cos(double x) {
    return math_cos(x);
}

double tan(double x) {
    return math_tan(x);
}

double asin(double x) {
    return math_asin(x);
}

double fmod(double x, double y) {
    return math_fmod(x, y);
}

/* Of a number and a NaN the number. */
double fmin(double x, double y) {
    return x < y || y != y ? x : y;
}

double fmax(double x, double y) {
    return x > y || y != y ? x : y;
}
