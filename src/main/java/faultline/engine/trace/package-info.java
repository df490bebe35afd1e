/**
 * Traces as files: a row of values for every tick, in one of two formats. The thread of the run collects the values; a
 * second thread turns them into text and writes it. Nothing here depends on metrics.
 */
package faultline.engine.trace;
