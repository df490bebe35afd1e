/**
 * What forms are built of: fields, labels and layouts, for the control panel and for dialogs. Event dispatch thread
 * only. They know neither a scenario nor its run.
 */
package faultline.gui.form;
