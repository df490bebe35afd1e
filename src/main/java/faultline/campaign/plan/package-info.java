/**
 * Campaign plans, which define the runs of a study. A plan file names worlds, seeds and factors. The scenario of each
 * run depends only on the plan and the run's index, so that any process can make any part of a campaign. Does not
 * depend on threads and output files; immutable once read, safe on any thread.
 */
package faultline.campaign.plan;
