/**
 * The examples that ship with the program, with small pictures of them. Event dispatch thread only; the pictures are
 * rendered on a background thread.
 */
package faultline.gui.gallery;
