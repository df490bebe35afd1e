/** The texts of the window, by key; in English, and in whatever other language has a file beside it. */
package faultline.gui.text;
