/**
 * The examples that ship with the program, with small pictures of them. Event dispatch thread only; the pictures are
 * made off it.
 */
package faultline.gui.gallery;
