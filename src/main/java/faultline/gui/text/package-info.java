/** The texts of the user interface by key, in English and in every language that has a properties file. */
package faultline.gui.text;
