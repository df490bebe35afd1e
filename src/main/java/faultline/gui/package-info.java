/** The front door of the window. */
package faultline.gui;
