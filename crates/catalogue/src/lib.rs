//! Every operator once: names, parameters, help, example, call.
