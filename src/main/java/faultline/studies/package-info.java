/**
 * The results of the paper and the studies beyond it. Each is a small class that writes its own files: pictures as SVG
 * and their numbers as CSV. {@link faultline.studies.Figures} lists them. A study depends only on the program, so it
 * writes the same bytes every time, on any thread.
 */
package faultline.studies;
