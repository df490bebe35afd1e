/**
 * The paper's results and the studies beyond it, each as a small class that writes its own files: pictures as SVG and
 * the numbers behind them as CSV. {@link faultline.studies.Figures} lists them. A study depends on nothing but the
 * program itself, so it gives the same bytes every time, and any thread may run it.
 */
package faultline.studies;
