/* The C interface from C, as a program of a user would call it. */
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "api/ehl.h"

static int failures = 0;

static void expect(int holds, const char* what) {
  printf("%s: %s\n", holds ? "ok" : "FAILED", what);
  if (!holds) ++failures;
}

static const char* circle =
    "[contact]\nM = 20\nL = 5\n\n[lubricant]\nalpha = 2.2e-8\n\n[grid]\ncells = 64\n\n[output]\nfields = P, H\n";

static int solved(const ehl_result* result) {
  for (size_t k = 0; ehl_message(result, k) != NULL; ++k) printf("message: %s\n", ehl_message(result, k));
  fflush(stdout);
  return ehl_status(result) == EHL_SOLVED;
}

static double number(const ehl_result* result, const char* path) {
  ehl_entry entry;
  return ehl_find(result, path, &entry) && entry.kind == EHL_NUMBERS && entry.rank == 0 ? entry.values[0] : NAN;
}

static void solves_a_deck(void) {
  const char* set[] = {"domain.far_field=zero"}; /* the whole load lies on the nodes */
  ehl_result* r = ehl_run(circle, "circle", set, 1, 1, NULL, NULL);
  ehl_entry film, P, x, y, error;
  expect(solved(r) && ehl_message(r, 0) == NULL, "a deck is solved without a message");
  if (!solved(r)) return;
  expect(ehl_find(r, "/summary/Hc", &film) && film.rank == 0 && !strcmp(film.unit, "a^2/R"), "Hc has its unit");
  expect(!strcmp(film.error, "/summary/error_Hc") && ehl_find(r, film.error, &error) && error.values[0] > 0.0 &&
             error.values[0] < 0.2,
         "Hc names its error bar");
  expect(ehl_find(r, "/fields/P", &P) && ehl_find(r, "/grid/x", &x) && ehl_find(r, "/grid/y", &y), "P and its axes");
  expect(P.rank == 2 && P.dims[0] == y.dims[0] && P.dims[1] == x.dims[0], "row = y, column = x");
  /* The load, 2 pi/3, from the view: P = 0 at the edge. */
  double load = 0.0, centre = 0.0;
  const double area = (x.values[1] - x.values[0]) * (y.values[1] - y.values[0]);
  for (size_t j = 0; j < P.dims[0]; ++j)
    for (size_t i = 0; i < P.dims[1]; ++i) {
      const double value = P.values[(ptrdiff_t)j * P.strides[0] + (ptrdiff_t)i * P.strides[1]];
      load += area * value;
      if (fabs(x.values[i]) < 1e-12 && fabs(y.values[j]) < 1e-12) centre = value;
    }
  printf("load %.5f, 2 pi/3 = %.5f; P at the centre %.4f\n", load, 2.0 * 3.14159265358979 / 3.0, centre);
  expect(fabs(load / 2.0943951 - 1.0) < 1e-4, "the view's pressure carries the load");
  expect(centre > 0.9 && centre < 1.1, "and is that of Hertz at the centre");
  expect(strstr(ehl_report(r), "residual") != NULL && ehl_json(r)[0] == '{', "report and JSON");
  expect(!strcmp(ehl_attribute(r, "/levels", "columns"),
                 "level nx ny Hc Hm mesh_error_Hc mesh_error_Hm Hm_fitted P_max order_Hc "
                 "residual load_error cycles work_units seconds"),
         "a table states the order of its columns");
  expect(ehl_find(r, "/summary/nothing", &film) == 0 && ehl_entry_at(r, ehl_entry_count(r), &film) == 0,
         "what is not there is not found");
  ehl_free(r);
}

static void tells_all_errors(void) {
  const char* set[] = {"contact.M=-3", "grid.cels=64"};
  ehl_result* r = ehl_run(circle, "circle", set, 2, 1, NULL, NULL);
  expect(ehl_status(r) == EHL_WRONG_INPUT && ehl_message(r, 1) != NULL && ehl_message(r, 2) == NULL, "both errors");
  expect(strstr(ehl_message(r, 0), "cels") || strstr(ehl_message(r, 1), "cells"), "with the nearest key");
  expect(ehl_entry_count(r) == 0 && ehl_save(r, "c_library_none.h5", 1) == EHL_WRONG_INPUT, "and nothing to write");
  ehl_free(r);
  r = ehl_run(NULL, "no_such_deck.ini", NULL, 0, 1, NULL, NULL);
  expect(ehl_status(r) == EHL_WRONG_INPUT && strstr(ehl_message(r, 0), "no_such_deck.ini") != NULL, "a missing deck");
  ehl_free(r);
  r = ehl_open("no_such_result.h5");
  expect(ehl_status(r) == EHL_FILE_TROUBLE && ehl_message(r, 0) != NULL, "a missing file");
  ehl_free(r);
  ehl_free(NULL);
}

struct Heard {
  int calls;
  double last;
};

static int stop_at_third(void* context, double fraction, const char* text) {
  struct Heard* heard = context;
  heard->last = fraction;
  return text == NULL || ++heard->calls == 3;
}

static void stops_when_asked(void) {
  struct Heard heard = {0, 0.0};
  ehl_result* r = ehl_run(circle, "circle", NULL, 0, 1, stop_at_third, &heard);
  expect(ehl_status(r) == EHL_INTERRUPTED && heard.calls == 3, "the third word of progress ends it");
  expect(heard.last > 0.0 && heard.last < 1.0, "somewhere on its way");
  ehl_free(r);
}

static void saves_and_opens(void) {
  ehl_result* r = ehl_run(circle, "circle", NULL, 0, 2, NULL, NULL);
  expect(ehl_save(r, "c_library.h5", 1) == EHL_SOLVED, "the result is written");
  expect(ehl_save(r, "c_library.h5", 0) == EHL_FILE_TROUBLE && strstr(ehl_message(r, 0), "c_library.h5") != NULL,
         "and not written over unasked");
  ehl_result* file = ehl_open("c_library.h5");
  expect(ehl_status(file) == EHL_SOLVED && number(file, "/summary/Hc") == number(r, "/summary/Hc"),
         "the file has the same bits");
  ehl_entry kept, made;
  int same = ehl_find(file, "/fields/H", &kept) && ehl_find(r, "/fields/H", &made) && kept.dims[0] == made.dims[0] &&
             kept.dims[1] == made.dims[1];
  for (size_t j = 0; same && j < made.dims[0]; ++j)
    for (size_t i = 0; i < made.dims[1]; ++i)
      same = same && kept.values[(ptrdiff_t)j * kept.strides[0] + (ptrdiff_t)i * kept.strides[1]] ==
                         made.values[(ptrdiff_t)j * made.strides[0] + (ptrdiff_t)i * made.strides[1]];
  expect(same, "of the film at every node too");
  ehl_free(r);
  expect(number(file, "/summary/Hc") > 0.0, "results are independent");
  ehl_free(file);
}

static void a_line_has_one_row(void) {
  const char* set[] = {"contact.kind=line"};
  ehl_result* r = ehl_run(circle, "line", set, 1, 1, NULL, NULL);
  ehl_entry P;
  expect(solved(r) && ehl_find(r, "/fields/P", &P) && P.rank == 2 && P.dims[0] == 1 && P.dims[1] > 64,
         "a line contact is one row");
  ehl_free(r);
}

/* A case that one of several threads solves, saves and opens again. */
struct Work {
  const char* name;
  const char* set[6];
  size_t count;
  double Hc;     /* of the result */
  double opened; /* of its file */
  int status;
};

static void* work(void* context) {
  struct Work* own = context;
  char file[64];
  snprintf(file, sizeof file, "c_library_%s.h5", own->name);
  ehl_result* r = ehl_run(circle, own->name, own->set, own->count, 2, NULL, NULL);
  own->status = ehl_status(r);
  own->Hc = number(r, "/summary/Hc");
  if (ehl_save(r, file, 1) != EHL_SOLVED) own->status = EHL_FILE_TROUBLE;
  ehl_free(r);
  r = ehl_open(file);
  own->opened = number(r, "/summary/Hc");
  ehl_free(r);
  return NULL;
}

static void four_threads_call_at_a_time(void) {
  const struct Work cases[4] = {
      {.name = "circle", .set = {"contact.M=30"}, .count = 1},
      {.name = "line", .set = {"contact.kind=line", "contact.M=10", "grid.cells=256"}, .count = 3},
      {.name = "starved", .set = {"supply.H_oil=0.3", "grid.cells=32", "domain.x_inlet=-3"}, .count = 3},
      {.name = "in_time",
       .set = {"transient.end_time=0.05", "transient.load=0:1 0.05:1.1", "grid.cells=32", "domain.x_inlet=-3"},
       .count = 4}};
  struct Work alone[4], together[4];
  pthread_t threads[4];
  for (int k = 0; k < 4; ++k) {
    alone[k] = together[k] = cases[k];
    work(&alone[k]);
  }
  for (int k = 0; k < 4; ++k)
    if (pthread_create(&threads[k], NULL, work, &together[k]) != 0) expect(0, "a thread begins");
  for (int k = 0; k < 4; ++k) pthread_join(threads[k], NULL);
  for (int k = 0; k < 4; ++k) {
    printf("%s: Hc %.17g alone, %.17g beside three others\n", cases[k].name, alone[k].Hc, together[k].Hc);
    expect(alone[k].status == EHL_SOLVED && together[k].status == EHL_SOLVED, "solved and written");
    expect(alone[k].Hc == together[k].Hc && together[k].opened == together[k].Hc,
           "with the same bits, in its file too");
  }
}

int main(void) {
  expect(ehl_api_version() == EHL_API_VERSION && strstr(ehl_version(), "ehl ") != NULL, "versions");
  expect(strstr(ehl_keys(), "\"section\":\"contact\"") != NULL, "keys");
  solves_a_deck();
  tells_all_errors();
  stops_when_asked();
  saves_and_opens();
  a_line_has_one_row();
  four_threads_call_at_a_time();
  ehl_result* r = ehl_check(circle, "circle", NULL, 0, 1);
  expect(ehl_status(r) == EHL_SOLVED && number(r, "/scales/M") == 20.0 && ehl_report(r)[0] != '\0', "a check");
  ehl_free(r);
  return failures == 0 ? 0 : 1;
}
