/**
 * Wall following with whatever sensors are still trusted: a local map of what they saw free and saw hit, and a follower
 * that keeps the wall on the left of it. Objects belong to one controller and are used by one thread at a time; nothing
 * here knows the true world or judges sensors.
 */
package faultline.control.fallback;
