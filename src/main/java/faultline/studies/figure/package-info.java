/**
 * The parts that all figures and studies share: pictures, tables, numbers, statistics of samples, and the folder that
 * they are written to.
 */
package faultline.studies.figure;
