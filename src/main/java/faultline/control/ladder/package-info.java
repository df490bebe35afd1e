/**
 * The strategy ladder: which controller drives with the sensors that are still trusted. Objects belong to one run and
 * are used by one thread at a time; nothing here knows the true world.
 */
package faultline.control.ladder;
