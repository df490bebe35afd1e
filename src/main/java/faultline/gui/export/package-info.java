/**
 * Exports: images, animated GIFs, tables, the clipboard and the printer. They are started on the event dispatch thread
 * and written on background threads; a file is complete or does not exist.
 */
package faultline.gui.export;
