/**
 * What leaves the program: pictures, films, tables, the clipboard and the printer. Asked for on the event dispatch
 * thread, made off it; files are there whole or not at all.
 */
package faultline.gui.export;
