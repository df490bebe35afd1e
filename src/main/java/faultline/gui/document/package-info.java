/**
 * The open scenario, its file and its run: loading, saving, crash recovery, restarting and moving the run to other
 * ticks. Event dispatch thread only; files are read and written, and sessions started, on background threads.
 */
package faultline.gui.document;
