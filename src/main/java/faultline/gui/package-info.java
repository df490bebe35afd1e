/** The window: Swing on the event dispatch thread alone. It shows frames and sends commands; it computes nothing of the model. */
package faultline.gui;
