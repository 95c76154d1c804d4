/* The C interface of ehl: it takes the text of a deck and returns the numbers and fields of the contact, without
 * starting a program or writing a file. It serves C and every language that can call C: Python (src/python), Octave,
 * Julia, MATLAB.
 *
 *   ehl_result* r = ehl_run(NULL, "deck.ini", NULL, 0, 1, NULL, NULL);
 *   ehl_entry film;
 *   if (ehl_status(r) == EHL_SOLVED && ehl_find(r, "/summary/Hc", &film))
 *     printf("Hc = %g +- %g %%\n", film.values[0], ...);
 *   ehl_free(r);
 *
 * Texts are UTF-8 and end with a zero. A pointer that a function returns belongs to the result (or to the library) and
 * is valid as long as that exists. No function throws, exits, prints or changes signals. Results are independent: two
 * threads may solve two cases at the same time, but only one thread at a time may use one result. A process that has
 * solved with several threads must not fork and solve in the child.
 * A NULL that is not allowed is an error like any other: EHL_WRONG_INPUT with a message, or 0, or NULL. A result that
 * is NULL has the status EHL_INTERNAL_FAILURE and no content. */
#ifndef EHL_H
#define EHL_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define EHL_API __attribute__((visibility("default")))

/* Increases when a function or a member changes its meaning; it is part of the library's soname. A new function does
 * not increase it. */
#define EHL_API_VERSION 1
EHL_API int ehl_api_version(void);
/* "ehl 0.1.0 (commit ...)" and what the numerics in use were compiled for. */
EHL_API const char* ehl_version(void);

/* How a call ended; the numbers are the exit statuses of the program. */
enum {
  EHL_SOLVED = 0,           /* or checked, or opened */
  EHL_INTERNAL_FAILURE = 1, /* an error of ehl, or no memory */
  EHL_WRONG_INPUT = 2,      /* the deck: a message for each error */
  EHL_NOT_CONVERGED = 3,    /* numbers and fields may exist, but are not a solution */
  EHL_FILE_TROUBLE = 4,
  EHL_INTERRUPTED = 130 /* the progress function asked to stop */
};

typedef struct ehl_result ehl_result;

/* Is called in the thread of the caller several times a second, with the share of the work that is done and a text on
 * the present step. A return value other than 0 stops the run. */
typedef int (*ehl_progress)(void* context, double fraction, const char* text);

/* Solves a case. deck: its text; NULL: the file `name` is read. name: the name of the deck in messages; files that the
 * deck names are looked for in the folder of `name` and in the working directory. overrides: "section.key=value", or
 * "-section.key", which removes the key; may be NULL if count is 0. threads: 0: all cores that the process may use.
 * progress: may be NULL.
 * The result is NULL only if there is no memory for it; ehl_status says how the call ended. */
EHL_API ehl_result* ehl_run(const char* deck, const char* name, const char* const* overrides, size_t count, int threads,
                            ehl_progress progress, void* context);
/* Validates a deck and derives what `ehl check` prints (ehl_report); solves nothing. The entries are /deck, /scales and
 * /grid. */
EHL_API ehl_result* ehl_check(const char* deck, const char* name, const char* const* overrides, size_t count,
                              int threads);
/* Reads a result file. */
EHL_API ehl_result* ehl_open(const char* path);
/* Reads one case of a sweep with --keep. number: its row in the table, counted from 0. */
EHL_API ehl_result* ehl_open_case(const char* path, size_t number);
/* NULL is allowed. */
EHL_API void ehl_free(ehl_result* result);

EHL_API int ehl_status(const ehl_result* result);
/* The text of the k-th error; NULL if there are fewer errors. */
EHL_API const char* ehl_message(const ehl_result* result, size_t k);
/* The text of the k-th warning about an existing result; NULL if there are fewer warnings. */
EHL_API const char* ehl_warning(const ehl_result* result, size_t k);
/* The text that `ehl run` or `ehl check` prints; empty if nothing was computed. */
EHL_API const char* ehl_report(const ehl_result* result);
/* The JSON that `ehl run --json` prints; empty for a case that was only checked and for a result file. */
EHL_API const char* ehl_json(const ehl_result* result);

/* One entry of a result, as in the result file; the README lists the groups. */
enum { EHL_GROUP = 0, EHL_TEXT = 1, EHL_NUMBERS = 2 };
typedef struct {
  const char* path;     /* "/fields/P" */
  int kind;             /* EHL_GROUP, EHL_TEXT, EHL_NUMBERS */
  int whole;            /* for numbers: 1 if they are counts, or yes and no */
  const char* unit;     /* "-" for pure numbers; empty if there is none */
  const char* meaning;  /* may be empty */
  const char* error;    /* path of the number that is the estimated relative error of this one; may be empty */
  const char* text;     /* the text of a text entry, else NULL */
  int rank;             /* for numbers: 0 for a single one, up to 3 for (time or depth, y, x) */
  size_t dims[3];       /* lengths, `rank` of them */
  ptrdiff_t strides[3]; /* doubles from one to the next along each dimension */
  const double* values; /* the numbers, else NULL; fields are not copied: this is the solver's memory */
} ehl_entry;

EHL_API size_t ehl_entry_count(const ehl_result* result);
/* Returns 1 and sets the entry; returns 0 if there is no such entry. */
EHL_API int ehl_entry_at(const ehl_result* result, size_t k, ehl_entry* entry);
EHL_API int ehl_find(const ehl_result* result, const char* path, ehl_entry* entry);
/* The text of any other attribute; NULL if there is none. "columns" of a table: the names of its columns in order. */
EHL_API const char* ehl_attribute(const ehl_result* result, const char* path, const char* name);

/* Writes the result file of a case that was run, and its XDMF file, as `ehl run` does. overwrite: 0: an existing file
 * is an error. out: the status; the message is appended to those of the result. */
EHL_API int ehl_save(ehl_result* result, const char* path, int overwrite);

/* All sections and keys of the deck as JSON: {"sections": [...], "keys": [{"section", "name", "type", ...}]}. */
EHL_API const char* ehl_keys(void);

#ifdef __cplusplus
}
#endif
#endif
