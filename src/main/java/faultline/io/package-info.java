/**
 * Text and file utilities that know nothing of robots: decimal numbers that read back exactly, quoted text for
 * messages, spelling suggestions, and files that are replaced whole or not at all. Pure functions or short blocking
 * calls, safe on any thread.
 */
package faultline.io;
