/**
 * The paper's results, each as one small class that makes its own files: pictures as SVG, and the numbers behind them
 * as CSV. The list of them is {@link faultline.studies.Figures}. A figure hangs on nothing but the program itself, so
 * it is the same file every time and may be made on any thread.
 */
package faultline.app.figures;
