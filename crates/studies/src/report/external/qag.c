/* GSL's qag with 21 points between the given breaks; protocol in external.rs. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

typedef struct { double c, o, p; } Power;
typedef struct { double from, to, sign; int n; Power *powers; } Part;
typedef struct {
    double s, scale;
    int slope, exponential, breaks, parts;
    double *at;
    Part *part;
    long count;
} Problem;

static int whole(void) { int v; if (scanf("%d", &v) != 1) exit(2); return v; }
static double number(void) { double v; if (scanf("%lf", &v) != 1) exit(2); return v; }

static void read_problem(Problem *q) {
    q->s = number(), q->slope = whole(), q->exponential = whole(), q->scale = number();
    q->breaks = whole();
    q->at = malloc(q->breaks * sizeof *q->at);
    for (int i = 0; i < q->breaks; i++) q->at[i] = number();
    q->parts = whole();
    q->part = malloc(q->parts * sizeof *q->part);
    for (int i = 0; i < q->parts; i++) {
        Part *p = q->part + i;
        p->from = number(), p->to = number(), p->sign = number(), p->n = whole();
        p->powers = malloc(p->n * sizeof *p->powers);
        for (int k = 0; k < p->n; k++)
            p->powers[k].c = number(), p->powers[k].o = number(), p->powers[k].p = number();
    }
}

static double power(Power w, double x) {
    double b = x - w.o;
    if (w.p == 0) return w.c;
    if (w.p == 1) return w.c * b;
    if (w.p == 1.5) return w.c * b * sqrt(b);
    return w.c * pow(b, w.p);
}

static double integrand(double t, void *given) {
    Problem *q = given;
    double x = t / q->scale, s = q->s, law = 0, weight;
    q->count++;
    for (int i = 0; i < q->parts; i++) {
        Part *p = q->part + i;
        if (x >= p->from && x < p->to)
            for (int k = 0; k < p->n; k++) law += p->sign * power(p->powers[k], x);
    }
    if (q->exponential) return law * exp(-(t + fmin(s, 0)));
    weight = exp(s >= 0 ? -t * (s + t / 2) : -(s + t) * (s + t) / 2) * 0.3989422804014327;
    return law * (q->slope ? weight * (s + t) : weight);
}

static double integrate(Problem *q, double tolerance, gsl_integration_workspace *space, int *ok) {
    gsl_function f = {integrand, q};
    double total = 0;
    q->count = 0, *ok = 1;
    for (int i = 0; i + 1 < q->breaks; i++) {
        double value = 0, error;
        if (q->at[i + 1] <= q->at[i]) continue;
        if (gsl_integration_qag(&f, q->at[i], q->at[i + 1], 0, tolerance, 1000,
                                GSL_INTEG_GAUSS21, space, &value, &error))
            *ok = 0;
        total += value;
    }
    return total;
}

static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(void) {
    double tolerance;
    gsl_integration_workspace *space = gsl_integration_workspace_alloc(1000);
    gsl_set_error_handler_off();
    while (scanf("%lf", &tolerance) == 1) {
        int repeats = whole(), ok;
        double times[64] = {0};
        Problem q;
        read_problem(&q);
        for (int r = -1; r < repeats && r < 64; r++) { /* the first warms up */
            struct timespec a, b;
            clock_gettime(CLOCK_MONOTONIC, &a);
            integrate(&q, tolerance, space, &ok);
            clock_gettime(CLOCK_MONOTONIC, &b);
            if (r >= 0) times[r] = (b.tv_sec - a.tv_sec) * 1e9 + (b.tv_nsec - a.tv_nsec);
        }
        qsort(times, repeats, sizeof *times, ascending);
        double value = integrate(&q, tolerance, space, &ok);
        printf("%.17g %ld %d %.17g\n", value, q.count, ok, times[repeats / 2]);
    }
    return 0;
}
