/**
 * Wall following with the sensors that are still trusted: a local map of the free space and the surfaces that they saw,
 * and a follower that keeps the wall on the left. Objects belong to one controller and are used by one thread at a
 * time; nothing here knows the true world or judges sensors.
 */
package faultline.control.fallback;
