/** The entry point of the graphical user interface. */
package faultline.gui;
