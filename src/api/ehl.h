/* The C interface of ehl: one contact from the text of a deck to its numbers and fields, without a process or a file.
 * For C and for all that can call C: Python (src/python), Octave, Julia, MATLAB.
 *
 *   ehl_result* r = ehl_run(NULL, "deck.ini", NULL, 0, 1, NULL, NULL);
 *   ehl_entry film;
 *   if (ehl_status(r) == EHL_SOLVED && ehl_find(r, "/summary/Hc", &film))
 *     printf("Hc = %g +- %g %%\n", film.values[0], ...);
 *   ehl_free(r);
 *
 * Texts are UTF-8 and end with a zero. What a function returns a pointer to belongs to the result, or to the library,
 * and lives as long. No function throws, exits, prints or changes signals. Results are independent: two threads may
 * solve two cases at a time; one result belongs to one thread at a time. A process that has solved with several threads
 * must not fork and solve in the child.
 * A NULL where none is allowed is an error like any other: EHL_WRONG_INPUT with a message, 0 or NULL. Of a result that
 * is NULL the status is EHL_INTERNAL_FAILURE, and there is nothing else in it. */
#ifndef EHL_H
#define EHL_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define EHL_API __attribute__((visibility("default")))

/* Rises when a function or a member changes its meaning; the library's soname holds it. New functions do not raise it.
 */
#define EHL_API_VERSION 1
EHL_API int ehl_api_version(void);
/* "ehl 0.1.0 (commit ...)" and what the numerics in use were compiled for. */
EHL_API const char* ehl_version(void);

/* How a call ended: what the program gives the shell. */
enum {
  EHL_SOLVED = 0,           /* or checked, or opened */
  EHL_INTERNAL_FAILURE = 1, /* an error of ehl, or no memory */
  EHL_WRONG_INPUT = 2,      /* the deck: a message for each error */
  EHL_NOT_CONVERGED = 3,    /* numbers and fields may be there, and are no solution */
  EHL_FILE_TROUBLE = 4,
  EHL_INTERRUPTED = 130 /* the progress function asked for it */
};

typedef struct ehl_result ehl_result;

/* Hears from the thread that called, several times a second: the share of the work that is done, and what goes on.
 * Not 0: stop. */
typedef int (*ehl_progress)(void* context, double fraction, const char* text);

/* Solves a case. deck: its text; NULL: the file `name`. name: what messages call it; files that the deck names are
 * looked for beside it, and where the process runs. overrides: "section.key=value", or "-section.key", which takes it
 * out; may be NULL where count is 0. threads: 0: all cores that the process may use. progress: may be NULL.
 * Never NULL, but where there is no memory at all: ask ehl_status. */
EHL_API ehl_result* ehl_run(const char* deck, const char* name, const char* const* overrides, size_t count, int threads,
                            ehl_progress progress, void* context);
/* Validates a deck and derives what `ehl check` prints (ehl_report); solves nothing. The entries are /deck, /scales and
 * /grid. */
EHL_API ehl_result* ehl_check(const char* deck, const char* name, const char* const* overrides, size_t count,
                              int threads);
/* Reads a result file. */
EHL_API ehl_result* ehl_open(const char* path);
/* Reads a case of a sweep with --keep, by its number in the order of the table, from 0. */
EHL_API ehl_result* ehl_open_case(const char* path, size_t number);
/* NULL is allowed. */
EHL_API void ehl_free(ehl_result* result);

EHL_API int ehl_status(const ehl_result* result);
/* What went wrong, a text for each error; NULL from the last on. */
EHL_API const char* ehl_message(const ehl_result* result, size_t k);
/* What ehl warns of in a result that is there; NULL from the last on. */
EHL_API const char* ehl_warning(const ehl_result* result, size_t k);
/* What `ehl run` or `ehl check` prints; empty where nothing was computed. */
EHL_API const char* ehl_report(const ehl_result* result);
/* What `ehl run --json` prints; empty for a case that was only checked, or a file. */
EHL_API const char* ehl_json(const ehl_result* result);

/* What a result holds, as its file does: see the README for the groups. */
enum { EHL_GROUP = 0, EHL_TEXT = 1, EHL_NUMBERS = 2 };
typedef struct {
  const char* path;     /* "/fields/P" */
  int kind;             /* EHL_GROUP, EHL_TEXT, EHL_NUMBERS */
  int whole;            /* of numbers: 1: counts, or yes and no */
  const char* unit;     /* "-" for pure numbers; empty where there is none */
  const char* meaning;  /* may be empty */
  const char* error;    /* path of the number that is the estimated relative error of this one; may be empty */
  const char* text;     /* of a text, else NULL */
  int rank;             /* of numbers: 0 a single one, up to 3: (time or depth, y, x) */
  size_t dims[3];       /* lengths, `rank` of them */
  ptrdiff_t strides[3]; /* doubles from one to the next along each dimension */
  const double* values; /* of numbers, else NULL; fields are the solver's own memory */
} ehl_entry;

EHL_API size_t ehl_entry_count(const ehl_result* result);
/* 1 and the entry; 0 where there is none. */
EHL_API int ehl_entry_at(const ehl_result* result, size_t k, ehl_entry* entry);
EHL_API int ehl_find(const ehl_result* result, const char* path, ehl_entry* entry);
/* Another attribute, "columns" of a table: its columns in order; NULL where there is none. */
EHL_API const char* ehl_attribute(const ehl_result* result, const char* path, const char* name);

/* Writes the result file of a case that was run, and the XDMF beside it, as `ehl run` does. out: the status; the
 * message is then the result's last. overwrite: 0: an existing file is an error. */
EHL_API int ehl_save(ehl_result* result, const char* path, int overwrite);

/* All sections and keys of the deck as JSON: {"sections": [...], "keys": [{"section", "name", "type", ...}]}. */
EHL_API const char* ehl_keys(void);

#ifdef __cplusplus
}
#endif
#endif
