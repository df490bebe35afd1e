/**
 * Random rooms, each determined by a seed, for studies of many runs. Immutable values; nothing here reads a clock or a
 * file.
 */
package faultline.campaign;
