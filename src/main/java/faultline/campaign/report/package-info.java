/**
 * Reports of campaigns: reads a table of runs and makes one HTML page from it, with an interval for every share and
 * paired differences between variants. The page is self-contained and has no scripts. Any thread may call it.
 */
package faultline.campaign.report;
