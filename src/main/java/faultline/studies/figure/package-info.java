/** Code that all figures and studies share: pictures, tables, numbers, statistics of samples, and the target folder. */
package faultline.studies.figure;
