// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/output/output_parameters.h>
#include <stickslip/parameters/entries.h>

namespace StickSlip
{
  namespace
  {
    void
    add_cadence(ParameterHandler  &prm,
                const std::string &name,
                CadenceParameters &cadence,
                const std::string &what_happens,
                const std::string &the_last_ones,
                const std::string &things,
                const std::string &automatic_slip,
                const std::string &automatic_interval)
    {
      add_number(prm,
                 name + " slip rate factor",
                 cadence.slip_rate_factor,
                 NumberRange().above(1),
                 what_happens +
                   " when the largest slip rate has changed by this factor "
                   "since " +
                   the_last_ones + ", without unit.");
      add_number(prm,
                 name + " slip interval",
                 cadence.slip_interval,
                 NumberRange().at_least(0).in("m"),
                 what_happens +
                   " when the largest slip rate would have made the fault slip "
                   "this far since then, in m; 0: not for this reason. auto: " +
                   automatic_slip +
                   " of the largest prescribed velocity times 'End time', if "
                   "that is more.");
      add_number(prm,
                 name + " shortest interval",
                 cadence.shortest_interval,
                 NumberRange().at_least(0).in("s"),
                 "Shortest time between two " + things + ", in s.");
      add_number(prm,
                 name + " longest interval",
                 cadence.longest_interval,
                 NumberRange().above(0).in("s"),
                 "Longest time between two " + things +
                   ", in s; exceeded only by a longer time step. auto: " +
                   automatic_interval + ".");
    }
  } // namespace



  void
  OutputParameters::add_parameters(ParameterHandler &prm)
  {
    add_text(prm,
             "Output directory",
             directory,
             "Folder of all files; empty: output/ and the name of the "
             "parameter file.");
    add_count(prm,
              "Time series steps",
              time_series_steps,
              0,
              1000000,
              "A row is added to time_series.csv after every so many accepted "
              "steps, and after the last one, without unit; 0: there is no "
              "such file.");
    add_switch(prm,
               "Write faults",
               write_faults,
               "Whether faults.h5 is written.");
    add_selection(
      prm,
      "Fault fields",
      fault_fields,
      fault_field_names(),
      "What faults.h5 and the VTU files of the faults hold: slip (m), "
      "slip_rate (m/s), shear_traction (Pa), "
      "normal_stress (Pa), state (s); contact_pressure (Pa), the force that "
      "keeps the sides together over the area, which friction feels only "
      "where the normal stress follows it; contact_weight, each node's share "
      "in the area of contact (m, in three dimensions m^2), which changes as "
      "bodies slide; position (m), where the nodes are as they move, which the "
      "VTU files hold in any case, as contact_weight; and of faults that may "
      "open gap (m), opening_rate (m/s), contact_state (3: bonded, 2: stuck, "
      "1: slipping, faster than Event start slip rate, 0: open).");
    add_cadence(prm,
                "Fault",
                fault_cadence,
                "A record is added to faults.h5",
                "the last one",
                "records in faults.h5",
                "1e-5 m, or, in runs of more than 1000 s, 1/2000",
                "0.5 s; in runs of more than 1000 s 1/2000 of 'End time'");
    prm.declare_entry(
      "Stations",
      StationList::text(stations),
      StationList(),
      "Points of faults and bodies whose fields are recorded in "
      "stations/NAME.dat, in the form of the SEAS benchmarks: of a fault slip "
      "(m), log10 of the slip rate (m/s), shear stress (MPa), normal stress "
      "(MPa), where it follows slip, and log10 of the state (s); of a body "
      "displacement (m) and velocity (m/s). Coordinates are those of the "
      "unmoved bodies.");
    prm.add_action("Stations", [this](const std::string &text) {
      stations = StationList::values(text);
    });
    add_cadence(prm,
                "Station",
                station_cadence,
                "A line is added to the files of all stations",
                "the last one",
                "lines in the files of stations",
                "1e-5 m, or, in runs of more than 1000 s, 1/2000",
                "0.5 s; in runs of more than 1000 s 1/2000 of 'End time'");
    add_switch(prm,
               "Write fault surfaces",
               write_fault_surfaces,
               "Whether VTU files of the faults are written, at the times of "
               "those of the bodies, be these written or not.");
    add_switch(prm,
               "Write volume",
               write_volume,
               "Whether VTU files of the bodies are written.");
    add_selection(
      prm,
      "Volume fields",
      volume_fields,
      volume_field_names(),
      "What the VTU files hold: displacement (m), velocity (m/s), "
      "acceleration (m/s^2, where there is inertia); of each cell's centre "
      "stress (elastic part, Pa, tension positive), strain (without unit), "
      "the place of the body in Bodies/Names, from zero, and the material, as "
      "far as it varies in any body.");
    add_switch(prm,
               "Volume pieces",
               volume_pieces,
               "Whether each process writes its part of the bodies into a VTU "
               "file of its own, which a PVTU file joins: for large meshes on "
               "many processes. Otherwise one process writes all, up to 2 GB "
               "a field, the same for any number of processes.");
    add_cadence(prm,
                "Volume",
                volume_cadence,
                "VTU files are written",
                "the last ones",
                "sets of VTU files",
                "1e-4 m, or, in runs of more than 1000 s, 1/100",
                "5 s; in runs of more than 1000 s 1/200 of 'End time'");
    add_number(prm,
               "Event start slip rate",
               event_start_slip_rate,
               NumberRange().at_least(0).in("m/s"),
               "An event begins when the mean slip rate of a fault rises above "
               "this, in m/s; 0: twice the largest prescribed velocity.");
    add_number(prm,
               "Event end fraction",
               event_end_fraction,
               NumberRange().above(0).at_most(1),
               "An event ends when the mean slip rate falls below this "
               "fraction of the rate at which it begins, without unit.");
    add_number(prm,
               "Opening threshold",
               opening_threshold,
               NumberRange().at_least(0).in("m"),
               "An opening begins when the largest gap of a fault rises above "
               "this, in m, and ends when it falls below half of it; 0: 1e-8 "
               "of the fault's extent.");
    add_number(prm,
               "Checkpoint interval",
               checkpoint_interval,
               NumberRange().at_least(0).in("s"),
               "A checkpoint is written, from which '--restart' goes on, when "
               "the simulated time passes a multiple of this, in s; 0: not for "
               "this reason.");
    add_number(prm,
               "Checkpoint wall time",
               checkpoint_wall_time,
               NumberRange().at_least(0).in("s"),
               "A checkpoint is written when the program has run for this long "
               "since the last one, in s; 0: not for this reason.");
    add_count(prm,
              "Checkpoints kept",
              checkpoints_kept,
              0,
              1000000,
              "The last so many checkpoints stay, without unit; where there "
              "are any, one is also written when a run ends or is "
              "interrupted; 0: none are written.");
    add_switch(prm,
               "Energy balance",
               energy_balance,
               "Whether the work of all forces is added up in every step, and "
               "compared with the change of energy in summary.txt.");
  }
} // namespace StickSlip
