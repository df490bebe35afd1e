/**
 * Batches: many runs of the open scenario over seeds, faults and sensors, made by the campaign engine in the
 * background; tables and a histogram of their results, or of results that are read again; any run opens in the window.
 * The plan and the results are the files of the command {@code campaign}. Event dispatch thread only, except for the
 * code that makes runs, and that reads and writes files.
 */
package faultline.gui.batch;
