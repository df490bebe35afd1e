/**
 * Random rooms by seed, in which studies of many runs are made. Immutable values; nothing here reads a clock or a file.
 */
package faultline.campaign;
