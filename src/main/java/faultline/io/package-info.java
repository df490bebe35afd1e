/**
 * Text and file utilities that do not depend on robots: decimal numbers that are read back exactly, quoted text for
 * messages, spelling suggestions, files that are replaced atomically, and shutdown hooks. Pure functions or short
 * blocking calls, safe on any thread.
 */
package faultline.io;
